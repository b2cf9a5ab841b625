#include "scene/physics/entity_bodies.hpp"

#include <utility>

#include "core/log.hpp"
#include "ecs/hierarchy.hpp"
#include "physics/model/bodies.hpp"
#include "scene/components/name.hpp"
#include "scene/components/scene_entity.hpp"
#include "scene/physics/game_errors.hpp"

namespace plumb {

std::string describedEntity(const World& world, EntityId entity) {
    const Name* name = world.find<Name>(entity);
    const SceneEntity* part = world.find<SceneEntity>(entity);
    const std::string words{name == nullptr ? std::string_view{} : world.texts().find(name->text)};
    if (part == nullptr)
        return words.empty() ? format("entity {}", entity.index)
                             : format("{} (entity {})", words, entity.index);
    return format("{} @{}", words.empty() ? "entity" : words, hexText(part->id));
}

physics::BodyId bodyOf(const PhysicsState& state, EntityId entity) {
    if (entity.index >= state.bodyOf.size() || state.bodyOf[entity.index] == 0) return {};
    const std::uint32_t index = state.bodyOf[entity.index] - 1;
    if (state.links[index].entity != entity) return {};
    return {index, state.world.bodies.info[index].generation};
}

void placeEntity(World& world, WorldPoses& poses, EntityId entity, const Pose& pose) {
    Transform* transform = world.find<Transform>(entity);
    if (transform == nullptr) return;
    poses.forget(entity);
    const EntityId parent = parentOf(std::as_const(world), entity);
    if (!parent) {
        transform->position = pose.position;
        transform->rotation = pose.rotation;
        return;
    }
    const Pose local = relativeTo(poses.of(world, parent), {pose.position, pose.rotation, {1.0f, 1.0f}});
    transform->position = local.position;
    transform->rotation = local.rotation;
}

void logRefusal(const World& world, const PhysicsState& state, EntityId entity, const Error& error) {
    if (!world.reports().isFirst("Physics", error.where, entity.index)) return;
    Error shown = gameError(error, {}, state.scale);
    if (entity) shown.where = format("{}: {}", describedEntity(world, entity), shown.where);
    logWarning("Physics", shown);
}

}  // namespace plumb
