#include "scene/world_transform.hpp"

#include <cstddef>
#include <utility>
#include <vector>

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

namespace {

Pose ownPose(const World& world, EntityId entity, float alpha) {
    const auto* transform = world.find<Transform>(entity);
    return transform != nullptr ? interpolated(*transform, alpha) : Pose{};
}

}  // namespace

Pose worldPose(const World& world, EntityId entity, float alpha) {
    EntityId parent = parentOf(world, entity);
    if (!parent) return ownPose(world, entity, alpha);
    // From the root down, as rounding makes the order of the compositions visible. Scratch memory, as a
    // chain of entities may be too long for the stack.
    thread_local std::vector<EntityId> path;
    path.assign(1, entity);
    for (; parent; parent = parentOf(world, parent)) path.push_back(parent);
    Pose pose = ownPose(world, path.back(), alpha);
    for (std::size_t i = path.size() - 1; i-- > 0;) pose = composed(pose, ownPose(world, path[i], alpha));
    return pose;
}

Pose WorldPoses::of(const World& world, EntityId entity, float alpha) {
    if (!parentOf(world, entity)) return ownPose(world, entity, alpha);
    if (alpha != alpha_) clear();
    alpha_ = alpha;
    path_.clear();
    EntityId at = entity;
    for (; at && !isKnown(at); at = parentOf(world, at)) path_.push_back(at);
    Pose pose = at ? known_[at.index].pose : Pose{};
    for (std::size_t i = path_.size(); i-- > 0;) {
        const Pose own = ownPose(world, path_[i], alpha);
        pose = !at && i + 1 == path_.size() ? own : composed(pose, own);
        if (!world.alive(path_[i])) continue;
        if (path_[i].index >= known_.size()) known_.resize(path_[i].index + 1);
        known_[path_[i].index] = {pass_, path_[i].generation, pose};
    }
    return pose;
}

namespace {

/// Counters at the last storePreviousTransforms(), so that entities that do not move cost no time. A world
/// resource, not part of the simulation state.
struct StoredTransforms {
    static constexpr bool kNotSaved = true;

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
