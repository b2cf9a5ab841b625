#include "physics/easing.hpp"

#include <algorithm>
#include <cmath>

namespace plumb::physics {

namespace {

constexpr int kEasingShift = 13;
constexpr int kMostEasing = 7;
constexpr int kEasingSteps = 16;       // after which the number is one less
constexpr float kEasingUnit = 0.008f;  // m: overlap left alone is this times the square of the number

/// The number that belongs to an overlap, m.
int easingOf(float depth) {
    return std::min(static_cast<int>(std::sqrt(depth / kEasingUnit)) + 1, kMostEasing);
}

/// How deep what has just begun may be by the motion of the bodies in a step, m, generously.
float reachedByMotion(const World& world, const Contact& contact) {
    constexpr float kLongStep = 1.0f / 30.0f;  // s
    const BodyMotion& a = world.bodies.motion[contact.bodyA];
    const BodyMotion& b = world.bodies.motion[contact.bodyB];
    const float turning = std::fabs(a.angularVelocity) * world.bodies.info[contact.bodyA].reach +
                          std::fabs(b.angularVelocity) * world.bodies.info[contact.bodyB].reach;
    return world.settings.slop + kLongStep * (length(b.velocity - a.velocity) + turning);
}

}  // namespace

void noteOverlap(const World& world, Contact& contact) {
    contact.flags &= static_cast<std::uint16_t>(~kEasing);
    if ((contact.flags & (kOneWayA | kOneWayB)) != 0) return;  // what is inside falls through
    const float depth = -std::min(contact.separation0, contact.separation1);
    if (depth <= 2.0f * world.settings.slop || depth <= reachedByMotion(world, contact)) return;
    contact.flags |= static_cast<std::uint16_t>(easingOf(depth) << kEasingShift);
}

void ease(const World& world, Contact& contact) {
    const auto phase = static_cast<int>(world.steps % kEasingSteps);
    if (phase == 0) contact.flags -= static_cast<std::uint16_t>(1 << kEasingShift);
    const int left = (contact.flags >> kEasingShift) * kEasingSteps - phase;  // falls by 1 a step
    const float number = std::max(static_cast<float>(left) * (1.0f / kEasingSteps), 0.0f);
    const float hidden = kEasingUnit * number * number;
    if (contact.separation0 < 0.0f) contact.separation0 = std::min(contact.separation0 + hidden, 0.0f);
    if (contact.separation1 < 0.0f) contact.separation1 = std::min(contact.separation1 + hidden, 0.0f);
}

}  // namespace plumb::physics
