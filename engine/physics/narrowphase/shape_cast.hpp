#pragma once

#include <optional>

#include "physics/narrowphase/distance.hpp"

namespace plumb::physics {

/// Where a moving outline meets another.
struct CastHit {
    float fraction = 0.0f;  ///< ratio of the way, 0..1
    Vec2 normal;            ///< length 1, out of the outline that stands still
    Vec2 point;             ///< m: on it
    float overlap = 0.0f;   ///< m: how deep they were inside each other at the beginning
};

/// Moves B straight along `way`, without turning, until it touches A. In A's frame. What overlaps from the
/// beginning is hit at 0.
/// Source: conservative advancement, see time_of_impact.hpp; along a straight way it doubles its digits
std::optional<CastHit> castShape(const Convex& a, const Convex& b, const Frame& bInA, Vec2 way);

}  // namespace plumb::physics
