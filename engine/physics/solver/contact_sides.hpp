#pragma once

#include <algorithm>
#include <cmath>

#include "physics/workspace.hpp"

namespace plumb::physics {

// Scalar access to single contacts of a block, for what is too rare to be vectorized.

/// One body at one point of a contact.
struct ContactSide {
    Float4* velocity;
    float inverseInertia;
    float lever;
};

inline float speedAlong(const ContactSide& side, float nx, float ny) {
    return side.velocity->x * nx + side.velocity->y * ny + side.velocity->z * side.lever;
}

inline void pushAlong(const ContactSide& side, float impulse, float nx, float ny) {
    side.velocity->x += side.velocity->w * (impulse * nx);
    side.velocity->y += side.velocity->w * (impulse * ny);
    side.velocity->z += side.inverseInertia * (impulse * side.lever);
}

inline ContactSide sideA(Workspace& work, const ContactBlock& block, int p, int i) {
    return {&work.velocity[static_cast<std::size_t>(block.a[i])], block.inverseInertiaA[i],
            block.points[p].leverA[i]};
}
inline ContactSide sideB(Workspace& work, const ContactBlock& block, int p, int i) {
    return {&work.velocity[static_cast<std::size_t>(block.b[i])], block.inverseInertiaB[i],
            block.points[p].leverB[i]};
}
inline ContactSide sideB(Workspace& work, const FixedContactBlock& block, int p, int i) {
    return {&work.velocity[static_cast<std::size_t>(block.b[i])], block.inverseInertia[i],
            block.points[p].lever[i]};
}

inline float approachOf(Workspace& work, const ContactBlock& block, int p, int i) {
    return speedAlong(sideB(work, block, p, i), block.normalX[i], block.normalY[i]) -
           speedAlong(sideA(work, block, p, i), block.normalX[i], block.normalY[i]);
}
inline float approachOf(Workspace& work, const FixedContactBlock& block, int p, int i) {
    return speedAlong(sideB(work, block, p, i), block.normalX[i], block.normalY[i]) -
           block.points[p].approach[i];
}

inline void pushApart(Workspace& work, const ContactBlock& block, int p, int i, float impulse) {
    pushAlong(sideA(work, block, p, i), -impulse, block.normalX[i], block.normalY[i]);
    pushAlong(sideB(work, block, p, i), impulse, block.normalX[i], block.normalY[i]);
}
inline void pushApart(Workspace& work, const FixedContactBlock& block, int p, int i, float impulse) {
    pushAlong(sideB(work, block, p, i), impulse, block.normalX[i], block.normalY[i]);
}

/// m: displacement of a body's point along the normal in this step.
inline float movedAlong(const Float4& deltaPosition, float nx, float ny, float lever, float turn) {
    return deltaPosition.x * nx + deltaPosition.y * ny + (deltaPosition.z * lever + deltaPosition.w * turn);
}

/// Relative motion of two bodies along the normal during the step.
struct Approach {
    float displacement;  // m: change of their separation since the start of the step
    float acceleration;  // m/s2 of B relative to A
};

inline Approach approachIn(const Workspace& work, const ContactBlock& block, int p, int i, float /*dt*/) {
    const auto a = static_cast<std::size_t>(block.a[i]), b = static_cast<std::size_t>(block.b[i]);
    const float nx = block.normalX[i], ny = block.normalY[i];
    return {movedAlong(work.deltaPosition[b], nx, ny, block.points[p].leverB[i], block.turnB[i]) -
                movedAlong(work.deltaPosition[a], nx, ny, block.points[p].leverA[i], block.turnA[i]),
            (work.drive[b].x - work.drive[a].x) * nx + (work.drive[b].y - work.drive[a].y) * ny};
}
inline Approach approachIn(const Workspace& work, const FixedContactBlock& block, int p, int i, float dt) {
    const auto b = static_cast<std::size_t>(block.b[i]);
    const float nx = block.normalX[i], ny = block.normalY[i];
    return {movedAlong(work.deltaPosition[b], nx, ny, block.points[p].lever[i], block.turn[i]) -
                block.points[p].approach[i] * dt,
            work.drive[b].x * nx + work.drive[b].y * ny};
}

/// m2/s2: square of a speed after a displacement: v^2 = v0^2 + 2 a s.
inline float squareAfter(float square, float acceleration, float displacement) {
    return std::max(square + 2.0f * acceleration * displacement, 0.0f);
}

/// m/s: relative velocity at the impact. Gravity acts between the start of the step and the impact: without
/// it a ball would lose or gain height in each bounce.
inline float speedOfImpact(float before, const Approach& approach) {
    return -std::sqrt(squareAfter(before * before, approach.acceleration, approach.displacement));
}

/// m/s: relative velocity at the end of the step. The bounce happens where the bodies touch, be that before
/// the step or within it, and gravity acts from there on; otherwise a bounce that is detected deep inside
/// would lose that depth in height. Never faster than a bounce without loss.
/// @param gap  m, at the start of the step
inline float speedOfBounce(float before, float bounciness, float gap, const Approach& approach) {
    const float pull = approach.acceleration,
                maximum = squareAfter(before * before, pull, approach.displacement);
    const float met = squareAfter(before * before, pull, -gap);
    const float left = squareAfter(bounciness * bounciness * met, pull, gap + approach.displacement);
    return std::sqrt(std::min(left, maximum));
}

}  // namespace plumb::physics
