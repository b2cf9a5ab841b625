#pragma once

#include <algorithm>

#include "physics/workspace.hpp"

namespace plumb::physics {

// Scalar access to single contacts of a block, for rare cases. p: index of the point, i: lane.

/// Returns the velocity (m/s) of a point of one body along the normal.
inline float speedAlong(const Workspace& work, const RotatingSide& side, int p, int i, Vec2 normal) {
    const Float4& velocity = work.velocity[static_cast<std::size_t>(side.slot[i])];
    return velocity.x * normal.x + velocity.y * normal.y + velocity.z * side.lever[p][i];
}
inline float speedAlong(const Workspace&, const FixedSide<2>& side, int p, int i, Vec2) {
    return side.approach[p][i];
}

inline void pushAlong(Workspace& work, const RotatingSide& side, int p, int i, Vec2 normal, float impulse) {
    Float4& velocity = work.velocity[static_cast<std::size_t>(side.slot[i])];
    velocity.x += velocity.w * (impulse * normal.x);
    velocity.y += velocity.w * (impulse * normal.y);
    velocity.z += side.inverseInertia[i] * (impulse * side.lever[p][i]);
}
inline void pushAlong(Workspace&, const FixedSide<2>&, int, int, Vec2, float) {}

/// Returns the velocity (m/s) of B relative to A along the normal.
template <class Block>
float approachOf(const Workspace& work, const Block& block, int p, int i) {
    const Vec2 normal = block.normal.at(i);
    return speedAlong(work, block.b, p, i, normal) - speedAlong(work, block.a, p, i, normal);
}

template <class Block>
void pushApart(Workspace& work, const Block& block, int p, int i, float impulse) {
    pushAlong(work, block.a, p, i, block.normal.at(i), -impulse);
    pushAlong(work, block.b, p, i, block.normal.at(i), impulse);
}

/// Motion of a contact point of a body during the step.
struct PointMotion {
    float displacement;  // m, along the normal
    Vec2 acceleration;   // m/s2
};

inline PointMotion motionOf(const Workspace& work, const RotatingSide& side, int p, int i, Vec2 normal,
                            float) {
    const auto slot = static_cast<std::size_t>(side.slot[i]);
    const Float4 &moved = work.deltaPosition[slot], &drive = work.drive[slot];
    return {moved.x * normal.x + moved.y * normal.y + (moved.z * side.lever[p][i] + moved.w * side.turn[i]),
            {drive.x, drive.y}};
}
inline PointMotion motionOf(const Workspace&, const FixedSide<2>& side, int p, int i, Vec2, float dt) {
    return {side.approach[p][i] * dt, {}};
}

/// Relative motion of two bodies along the normal during the step.
struct Approach {
    float displacement;  // m: change of their separation since the start of the step
    float acceleration;  // m/s2 of B relative to A
};

template <class Block>
Approach approachIn(const Workspace& work, const Block& block, int p, int i, float dt) {
    const Vec2 normal = block.normal.at(i);
    const PointMotion a = motionOf(work, block.a, p, i, normal, dt),
                      b = motionOf(work, block.b, p, i, normal, dt);
    return {b.displacement - a.displacement, dot(b.acceleration - a.acceleration, normal)};
}

/// Returns the square of a speed (m2/s2) after a displacement: v^2 = v0^2 + 2 a s.
inline float squareAfter(float square, float acceleration, float displacement) {
    return std::max(square + 2.0f * acceleration * displacement, 0.0f);
}

/// Returns the relative velocity (m/s) at the impact, including gravity between the start of the step and the
/// impact. Without it a ball would lose or gain height in each bounce.
inline float speedOfImpact(float before, const Approach& approach) {
    return -std::sqrt(squareAfter(before * before, approach.acceleration, approach.displacement));
}

/// Returns the relative velocity (m/s) at the end of the step. The bounce takes place where the bodies touch,
/// before or within the step, and gravity acts from there on; otherwise a bounce that is detected at an
/// overlap would lose that height. Never faster than a bounce without loss.
/// @param gap  m, at the start of the step
inline float speedOfBounce(float before, float bounciness, float gap, const Approach& approach) {
    const float pull = approach.acceleration,
                maximum = squareAfter(before * before, pull, approach.displacement);
    const float met = squareAfter(before * before, pull, -gap);
    const float left = squareAfter(bounciness * bounciness * met, pull, gap + approach.displacement);
    return std::sqrt(std::min(left, maximum));
}

}  // namespace plumb::physics
