#include "physics/effects/one_way.hpp"

#include <algorithm>

#include "physics/model/bounds.hpp"
#include "physics/shapes/convex.hpp"

namespace plumb::physics {

namespace {

Vec2 openDirection(const World& world, std::uint32_t shape) {
    const Rot rotation = world.bodies.pose[world.shapes.info[shape].body].rotation;
    return rotate(rotation, world.shapes.extrasOf(shape).oneWayDirection);
}

/// m: extent of an outline along a direction, from `origin`.
float farEnd(const World& world, std::uint32_t shape, Vec2 direction, WorldPosition origin) {
    const BodyPose& pose = world.bodies.pose[world.shapes.info[shape].body];
    const Convex convex = convexOf(world.shapes.geometry[shape], world.shapes.corners);
    const Vec2 local = unrotate(pose.rotation, direction);
    const Vec2 corner = convex.corners()[static_cast<std::size_t>(farthest(convex.corners(), local))].point;
    return dot(direction, pose.centre - origin) + dot(local, corner - pose.localCentre) + convex.radius;
}

/// m: clearance of `other` above the platform one step ago, along the open direction; below 0 if not above.
float heightBefore(const World& world, const Contact& contact, bool platformIsA, float dt) {
    const std::uint32_t platform = platformIsA ? contact.shapeA : contact.shapeB;
    const std::uint32_t other = platformIsA ? contact.shapeB : contact.shapeA;
    const BodyMotion& platformMotion = world.bodies.motion[world.shapes.info[platform].body];
    const BodyMotion& otherMotion = world.bodies.motion[world.shapes.info[other].body];
    const Vec2 open = openDirection(world, platform);
    const Vec2 out = platformIsA ? contact.normal : -contact.normal;
    const float closing = -dot(open, otherMotion.velocity - platformMotion.velocity);
    const float before = std::max(closing * dt, 0.0f);
    if (dot(out, open) > kSolidSide) {
        return std::min(contact.separation0, contact.count == 2 ? contact.separation1 : kFarAway) + before;
    }
    const WorldPosition origin = world.bodies.pose[world.shapes.info[platform].body].centre;
    return -farEnd(world, other, -open, origin) - farEnd(world, platform, open, origin) + before;
}

}  // namespace

bool dropsThrough(const World& world, const Contact& contact) {
    const auto asks = [&](std::uint32_t body) {
        return (world.bodies.info[body].flags & kDropsThrough) != 0;
    };
    return ((contact.flags & kOneWayA) != 0 && asks(contact.bodyB)) ||
           ((contact.flags & kOneWayB) != 0 && asks(contact.bodyA));
}

bool passesThrough(const World& world, const Contact& contact, float dt) {
    const float on = -kOnTop * world.settings.slop;
    return dropsThrough(world, contact) ||
           ((contact.flags & kOneWayA) != 0 && heightBefore(world, contact, true, dt) < on) ||
           ((contact.flags & kOneWayB) != 0 && heightBefore(world, contact, false, dt) < on);
}

bool passesThrough(const World& world, std::uint32_t oneWayShape, Vec2 displacement) {
    return dot(openDirection(world, oneWayShape), displacement) >= 0.0f;
}

}  // namespace plumb::physics
