#pragma once

#include <algorithm>
#include <cmath>

#include "physics/narrowphase/manifold.hpp"
#include "physics/tuning.hpp"

namespace plumb::physics {

/// m: separation of two axis-aligned boxes along x and along y; below 0: overlap.
/// @param way  m, from A's centre to B's
inline Vec2 gapOf(Vec2 halfA, Vec2 halfB, Vec2 displacement) {
    return {std::fabs(displacement.x) - halfA.x - halfB.x, std::fabs(displacement.y) - halfA.y - halfB.y};
}

/// True if the contact normal is along y. As for rotated boxes, a tolerance makes the choice the same every
/// time where both separations are nearly equal.
inline bool goesAlongY(Vec2 halfA, Vec2 halfB, Vec2 gap) {
    const float smallest = std::min(std::min(halfA.x, halfA.y), std::min(halfB.x, halfB.y));
    return gap.y > gap.x + std::min(kMaxFaceTie, kFaceTie * smallest);
}

/// Collides two axis-aligned boxes without rounded corners: a single contact point, in a frame at A's centre.
/// @param way  m, from A's centre to B's
[[nodiscard]] Manifold collideUpright(Vec2 halfA, Vec2 halfB, Vec2 displacement, float speculative);

}  // namespace plumb::physics
