#include "scene/world_transform.hpp"

#include <utility>

#include "ecs/hierarchy.hpp"
#include "ecs/paused.hpp"
#include "scene/components/drawing/camera.hpp"

namespace plumb {
namespace {

Vec2 divided(Vec2 a, Vec2 b) { return {b.x != 0.0f ? a.x / b.x : 0.0f, b.y != 0.0f ? a.y / b.y : 0.0f}; }

}  // namespace

Pose blended(const Transform& transform, float alpha) {
    Pose pose;
    pose.position = lerp(transform.previousPosition, transform.position, alpha);
    pose.rotation = transform.rotation == transform.previousRotation
                        ? transform.rotation
                        : lerpAngle(transform.previousRotation, transform.rotation, alpha);
    pose.scale = lerp(transform.previousScale, transform.scale, alpha);
    return pose;
}

Pose relativeTo(const Pose& parent, const Pose& child) {
    return {divided(rotated(child.position - parent.position, -parent.rotation), parent.scale),
            child.rotation - parent.rotation, divided(child.scale, parent.scale)};
}

Pose worldPose(const World& world, EntityId entity, float alpha) {
    const auto* transform = world.find<Transform>(entity);
    const Pose own = transform != nullptr ? interpolated(*transform, alpha) : Pose{};
    const EntityId parent = parentOf(world, entity);
    return parent ? composed(worldPose(world, parent, alpha), own) : own;
}

namespace {

/// Counters at the last storePreviousTransforms(), so that entities that do not move cost no time. A world
/// resource, not part of the simulation state.
struct StoredTransforms {
    std::uint64_t mark = 0;     // change mark of the world
    std::uint64_t members = 0;  // number of gains and losses of Transform and Paused components
};

void store(Transform& transform) {
    transform.previousPosition = transform.position;
    transform.previousRotation = transform.rotation;
    transform.previousScale = transform.scale;
}

bool isStored(const Transform& transform) {
    return transform.previousPosition == transform.position &&
           transform.previousRotation == transform.rotation && transform.previousScale == transform.scale;
}

}  // namespace

void storePreviousTransforms(World& world) {
    StoredTransforms& stored = world.resource<StoredTransforms>();
    const std::uint64_t members = world.memberships<Transform, Paused>();
    if (members != stored.members) {
        world.each<Transform>(store);  // except paused entities, which queries skip
    } else {
        world.eachChangedSince<Transform>(stored.mark, [&world](EntityId entity) {
            // const_cast, as this write must not be recorded as a change.
            auto* transform = const_cast<Transform*>(std::as_const(world).find<Transform>(entity));
            if (!isStored(*transform) && !world.has<Paused>(entity)) store(*transform);
        });
    }
    stored = {world.markChanges(), members};
    world.each<Camera>([](Camera& camera) { camera.previousZoom = camera.zoom; });
}

}  // namespace plumb
