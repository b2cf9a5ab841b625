#pragma once

#include <algorithm>
#include <cmath>

#include "physics/geometry.hpp"
#include "physics/narrowphase/manifold.hpp"

namespace plumb::physics {

/// m: how far two boxes are apart along x and y; below 0 they overlap.
/// @param way  m, from A's centre to B's
inline Vec2 gapOf(Vec2 halfA, Vec2 halfB, Vec2 way) {
    return {std::fabs(way.x) - halfA.x - halfB.x, std::fabs(way.y) - halfA.y - halfB.y};
}

/// Whether boxes that overlap are pushed apart along y. As boxes that turn: of two ways out that are about as
/// short the same one every time.
inline bool goesAlongY(Vec2 halfA, Vec2 halfB, Vec2 gap) {
    const float smallest = std::min(std::min(halfA.x, halfA.y), std::min(halfB.x, halfB.y));
    return gap.y > gap.x + std::min(0.0005f, 0.001f * smallest);
}

/// Two boxes without round corners, both along the axes: the one point that says where they meet, in the
/// frame of A's centre.
/// @param way  m, from A's centre to B's
[[nodiscard]] Manifold collideUpright(Vec2 halfA, Vec2 halfB, Vec2 way, float speculative);

}  // namespace plumb::physics
