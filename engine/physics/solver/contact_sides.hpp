#pragma once

#include <algorithm>
#include <cmath>

#include "physics/workspace.hpp"

namespace plumb::physics {

// One contact of a block at a time, for what is too rare to be done eight at once.

/// A body's part in one point of a contact.
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

/// m: how far a body's point moved along the normal in this step.
inline float movedAlong(const Float4& shift, float nx, float ny, float lever, float turn) {
    return shift.x * nx + shift.y * ny + (shift.z * lever + shift.w * turn);
}

/// How two bodies came together during the step, along the normal.
struct Approach {
    float way;           // m: how much further they are apart than before the step
    float acceleration;  // m/s2 of B from A
};

inline Approach approachIn(const Workspace& work, const ContactBlock& block, int p, int i, float /*dt*/) {
    const auto a = static_cast<std::size_t>(block.a[i]), b = static_cast<std::size_t>(block.b[i]);
    const float nx = block.normalX[i], ny = block.normalY[i];
    return {movedAlong(work.shift[b], nx, ny, block.points[p].leverB[i], block.turnB[i]) -
                movedAlong(work.shift[a], nx, ny, block.points[p].leverA[i], block.turnA[i]),
            (work.drive[b].x - work.drive[a].x) * nx + (work.drive[b].y - work.drive[a].y) * ny};
}
inline Approach approachIn(const Workspace& work, const FixedContactBlock& block, int p, int i, float dt) {
    const auto b = static_cast<std::size_t>(block.b[i]);
    const float nx = block.normalX[i], ny = block.normalY[i];
    return {movedAlong(work.shift[b], nx, ny, block.points[p].lever[i], block.turn[i]) -
                block.points[p].approach[i] * dt,
            work.drive[b].x * nx + work.drive[b].y * ny};
}

/// m2/s2: what is left of the square of a speed after a way, by v2 = v0 2 + 2 a s.
inline float squareAfter(float square, float acceleration, float way) {
    return std::max(square + 2.0f * acceleration * way, 0.0f);
}

/// m/s: how fast they met. Between the start of the step and the impact gravity went on: without it a ball
/// would lose, or gain, some height in each bounce.
inline float speedOfImpact(float before, const Approach& approach) {
    return -std::sqrt(squareAfter(before * before, approach.acceleration, approach.way));
}

/// m/s: how fast they part at the end of the step. The bounce is where they touch, be that before the step or
/// in it, and from there on gravity goes on too: else what is found deep inside would lose that depth of its
/// height. Never faster than without any loss.
/// @param gap  m, at the start of the step
inline float speedOfBounce(float before, float bounciness, float gap, const Approach& approach) {
    const float pull = approach.acceleration, most = squareAfter(before * before, pull, approach.way);
    const float met = squareAfter(before * before, pull, -gap);
    const float left = squareAfter(bounciness * bounciness * met, pull, gap + approach.way);
    return std::sqrt(std::min(left, most));
}

}  // namespace plumb::physics
