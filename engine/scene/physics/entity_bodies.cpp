#include "scene/physics/entity_bodies.hpp"

#include <algorithm>
#include <utility>

#include "core/log.hpp"
#include "ecs/hierarchy.hpp"
#include "physics/model/bodies.hpp"
#include "scene/components/name.hpp"
#include "scene/components/scene_entity.hpp"

namespace plumb {

namespace {

std::string nameOf(const World& world, EntityId entity) {
    const Name* name = world.find<Name>(entity);
    const SceneEntity* part = world.find<SceneEntity>(entity);
    const std::string words{name == nullptr ? std::string_view{} : world.texts().find(name->text)};
    if (part == nullptr) return words.empty() ? format("entity {}", entity.index) : words;
    return format("{} @{}", words.empty() ? "entity" : words, hexText(part->id));
}

}  // namespace

physics::BodyId bodyOf(const PhysicsState& state, EntityId entity) {
    if (entity.index >= state.bodyOf.size() || state.bodyOf[entity.index] == 0) return {};
    const std::uint32_t index = state.bodyOf[entity.index] - 1;
    if (state.links[index].entity != entity) return {};
    return {index, state.world.bodies.info[index].generation};
}

void placeEntity(World& world, EntityId entity, const Pose& pose) {
    Transform* transform = world.find<Transform>(entity);
    if (transform == nullptr) return;
    const EntityId parent = parentOf(std::as_const(world), entity);
    if (!parent) {
        transform->position = pose.position;
        transform->rotation = pose.rotation;
        return;
    }
    const Pose local = relativeTo(worldPose(world, parent), {pose.position, pose.rotation, {1.0f, 1.0f}});
    transform->position = local.position;
    transform->rotation = local.rotation;
}

void logRefusal(const World& world, PhysicsState& state, EntityId entity, const Error& error) {
    if (std::find(state.refused.begin(), state.refused.end(), entity) != state.refused.end()) return;
    state.refused.push_back(entity);
    logWarning("Physics",
               Error{format("{}: {}", nameOf(world, entity), error.where), error.what, error.remedy});
}

}  // namespace plumb
