#pragma once

#include <optional>

#include "physics/narrowphase/distance.hpp"

namespace plumb::physics {

/// Where a moving outline meets another.
struct ConvexHit {
    float fraction = 0.0f;    ///< ratio of the way, 0..1
    Vec2 normal;              ///< length 1, out of the outline that stands still
    Vec2 point;               ///< m: on it
    float separation = 0.0f;  ///< m between both at the beginning; negative: how deep they were inside
};

/// Moves B straight along `way`, without turning, until it touches A. In A's frame. What overlaps from the
/// beginning is hit at 0; what only touches is not hit by a way that leads off it or along it.
/// Source: conservative advancement, see sweep.hpp; along a straight way it doubles its digits
std::optional<ConvexHit> castShape(const Convex& a, const Convex& b, const Frame& bInA, Vec2 way);

}  // namespace plumb::physics
