#include <algorithm>

#include "physics/contacts/contacts.hpp"
#include "physics/ranges.hpp"
#include "physics/stages.hpp"

namespace plumb::physics {

namespace {

/// Returns the extent (m) of an outline along a direction, from `origin`.
float farEnd(const World& world, std::uint32_t shape, Vec2 direction, WorldPosition origin) {
    const BodyPose& pose = world.bodies.pose[world.shapes.info[shape].body];
    const Convex convex = convexOf(world.shapes.geometry[shape], world.shapes.corners);
    const Vec2 local = unrotate(pose.rotation, direction);
    const Vec2 corner = convex.corners()[static_cast<std::size_t>(farthest(convex.corners(), local))].point;
    return dot(direction, pose.centre - origin) + dot(local, corner - pose.localCentre) + convex.radius;
}

/// Returns the height (m) of `other` above the platform `dt` seconds ago, along the open direction.
float heightBefore(const World& world, const Contact& contact, bool platformIsA, float dt) {
    const std::uint32_t platform = platformIsA ? contact.shapeA : contact.shapeB;
    const std::uint32_t other = platformIsA ? contact.shapeB : contact.shapeA;
    const BodyMotion& platformMotion = world.bodies.motion[world.shapes.info[platform].body];
    const BodyMotion& otherMotion = world.bodies.motion[world.shapes.info[other].body];
    const Vec2 open = openDirection(world, platform);
    const Vec2 out = platformIsA ? contact.normal : -contact.normal;
    const float closing = -dot(open, otherMotion.velocity - platformMotion.velocity);
    const float before = std::max(closing * dt, 0.0f);
    if (dot(out, open) > kSolidSide)
        return std::min(contact.separation0, contact.count == 2 ? contact.separation1 : kFarAway) + before;
    const WorldPosition origin = world.bodies.pose[world.shapes.info[platform].body].centre;
    return -farEnd(world, other, -open, origin) - farEnd(world, platform, open, origin) + before;
}

/// True if the other body has the flag kDropsThrough.
bool dropsThrough(const World& world, const Contact& contact) {
    const auto asks = [&](std::uint32_t body) {
        return (world.bodies.info[body].flags & kDropsThrough) != 0;
    };
    return ((contact.flags & kOneWayA) != 0 && asks(contact.bodyB)) ||
           ((contact.flags & kOneWayB) != 0 && asks(contact.bodyA));
}

/// True if a one-way shape does not stop the other shape when they begin to touch, because it comes from
/// behind or is already inside. In a contact of two one-way shapes both have to stop each other.
/// @param dt  s: time before now at which positions are compared, as bodies begin to touch with an overlap
bool passesThrough(const World& world, const Contact& contact, float dt) {
    const float on = -kOnTop * world.settings.slop;
    return dropsThrough(world, contact) ||
           ((contact.flags & kOneWayA) != 0 && heightBefore(world, contact, true, dt) < on) ||
           ((contact.flags & kOneWayB) != 0 && heightBefore(world, contact, false, dt) < on);
}

/// Decides when a contact begins whether a one-way shape stops the other, so that none stops it halfway.
void decideOneWay(StepContext& step, Contact& contact) {
    if ((contact.flags & (kOneWayA | kOneWayB)) == 0) return;
    if ((contact.flags & kBegan) != 0) {
        contact.flags &= static_cast<std::uint16_t>(~kPassing);
        if (passesThrough(step.world, contact, step.dt)) contact.flags |= kPassing;
    } else if ((contact.flags & kPassing) == 0 && dropsThrough(step.world, contact)) {
        report(step.world, step.work, contact, ContactPhase::Ended);
        contact.flags |= kPassing;
    }
    if ((contact.flags & kPassing) != 0) contact.flags |= kDisabled;
}

}  // namespace

void askForMaterial(const StepContext& step, Contact& contact) {
    const auto answer = [&](auto* hook, float known, float maximum) {
        if (hook == nullptr) return known;
        const float wanted = ask(step.world, [&] { return hook(step.hooks.context, step.world, contact); });
        return wanted > 0.0f ? std::min(wanted, maximum) : 0.0f;
    };
    contact.friction = answer(step.hooks.friction, contact.friction, kRoughest);
    contact.bounciness = answer(step.hooks.bounciness, contact.bounciness, 1.0f);
}

void filterContacts(StepContext& step) {
    std::vector<Contact>& contacts = step.world.contacts;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        Contact& contact = contacts[i];
        if ((contact.flags & (kTouching | kTriggered)) != kTouching) continue;
        decideOneWay(step, contact);
        askForMaterial(step, contact);
        if ((contact.flags & kDisabled) == 0 && !mayPush(step, contact)) contact.flags |= kDisabled;
        if ((contact.flags & kDisabled) != 0) step.work.contactKeys[i] = keyOf(contact);
    }
}

}  // namespace plumb::physics
