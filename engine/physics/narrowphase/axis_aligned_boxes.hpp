#pragma once

#include <algorithm>
#include <cmath>

#include "physics/narrowphase/collide.hpp"

namespace plumb::physics {

/// Returns the separation (m) of two axis-aligned boxes along x and along y; below 0: overlap.
/// @param displacement  m, from A's centre to B's
inline Vec2 gapOf(Vec2 halfA, Vec2 halfB, Vec2 displacement) {
    return {std::fabs(displacement.x) - halfA.x - halfB.x, std::fabs(displacement.y) - halfA.y - halfB.y};
}

/// True if the contact normal is along y, false: x. If both separations are nearly equal, it is along x (a
/// tolerance, as for rotated boxes), so that the axis does not alternate.
inline bool goesAlongY(Vec2 halfA, Vec2 halfB, Vec2 gap) {
    const float smallest = std::min(std::min(halfA.x, halfA.y), std::min(halfB.x, halfB.y));
    return gap.y > gap.x + std::min(kMaxFaceTie, kFaceTie * smallest);
}

/// The touching features: ManifoldPoint::id.
enum UprightFeature : std::uint16_t { kFaceX = 0, kFaceY = 2, kCorner = 4 };

/// Collides boxes that are separated along both axes, corner to corner. side: signs of `displacement`.
inline Manifold collideUprightCorners(Vec2 halfA, Vec2 gap, Vec2 side, Vec2 displacement, float speculative) {
    const float square = lengthSquared(gap);
    if (square > speculative * speculative || square <= kBlur * kBlur * lengthSquared(displacement))
        return {};
    const float distance = std::sqrt(square);
    const Vec2 normal{side.x * (gap.x / distance), side.y * (gap.y / distance)};
    const Vec2 corner{side.x * halfA.x, side.y * halfA.y};
    const int quadrant = (side.x < 0.0f ? 1 : 0) + (side.y < 0.0f ? 2 : 0);
    const auto id = static_cast<std::uint16_t>(kCorner + quadrant);
    return {normal, {{corner + (0.5f * distance) * normal, distance, id}, {}}, 1};
}

/// Returns the middle of the intersection of two intervals, centred at 0 and at `displacement`.
inline float middleOfOverlap(float halfA, float halfB, float displacement) {
    return 0.5f * (std::max(-halfA, displacement - halfB) + std::min(halfA, displacement + halfB));
}

/// Collides two axis-aligned boxes without rounded corners: one contact point, in a frame at A's centre.
/// @param displacement  m, from A's centre to B's
[[nodiscard]] inline Manifold collideUpright(Vec2 halfA, Vec2 halfB, Vec2 displacement, float speculative) {
    const Vec2 gap = gapOf(halfA, halfB, displacement);
    if (std::max(gap.x, gap.y) > speculative) return {};
    const Vec2 side{displacement.x < 0.0f ? -1.0f : 1.0f, displacement.y < 0.0f ? -1.0f : 1.0f};
    if (gap.x > 0.0f && gap.y > 0.0f)
        return collideUprightCorners(halfA, gap, side, displacement, speculative);
    const auto at = [&](Vec2 normal, Vec2 point, float separation, int feature) {
        const int backwards = normal.x + normal.y < 0.0f ? 1 : 0;
        return Manifold{
            normal, {{point, separation, static_cast<std::uint16_t>(feature + backwards)}, {}}, 1};
    };
    if (goesAlongY(halfA, halfB, gap)) {
        const float x = middleOfOverlap(halfA.x, halfB.x, displacement.x);
        return at({0.0f, side.y}, {x, side.y * (halfA.y + 0.5f * gap.y)}, gap.y, kFaceY);
    }
    const float y = middleOfOverlap(halfA.y, halfB.y, displacement.y);
    return at({side.x, 0.0f}, {side.x * (halfA.x + 0.5f * gap.x), y}, gap.x, kFaceX);
}

}  // namespace plumb::physics
