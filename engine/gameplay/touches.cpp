#include "gameplay/touches.hpp"

#include <cmath>

#include "assets/asset_store.hpp"
#include "scene/components/colliders/box_collider.hpp"
#include "scene/components/drawing/animator.hpp"
#include "scene/world_transform.hpp"

namespace plumb {

AABB boxOf(const World& world, EntityId entity) {
    const auto& collider = world.get<BoxCollider>(entity);
    const Pose pose = worldPose(world, entity);
    const Vec2 corner = pose.position + collider.offset;
    return {corner,
            corner + Vec2{collider.width * std::abs(pose.scale.x), collider.height * std::abs(pose.scale.y)}};
}

void setParameter(World& world, EntityId entity, std::string_view name, float value) {
    const auto* animator = std::as_const(world).find<Animator>(entity);
    const auto* assets = world.service<AssetStore>();
    if (animator == nullptr || assets == nullptr || animator->animation.empty()) return;
    const int index = assets->animation(animator->animation).findParameter(name);
    if (index < 0 || static_cast<std::uint32_t>(index) >= animator->parameters.count) return;
    const auto at = static_cast<std::size_t>(index);
    if (animator->parameters[at] != value) world.get<Animator>(entity).parameters[at] = value;
}

}  // namespace plumb
