#pragma once

#include <optional>

#include "physics/narrowphase/distance.hpp"

namespace plumb::physics {

/// The first contact of a moving outline with another.
struct ConvexHit {
    float fraction = 0.0f;    ///< fraction of the displacement, 0..1
    Vec2 normal;              ///< unit length, outward from the outline at rest
    Vec2 point;               ///< m: on the outline at rest
    float separation = 0.0f;  ///< m between both at the start; negative: penetration depth
};

/// Moves B along `way`, without rotation, until it touches A. In A's frame. An initial overlap is a hit at 0;
/// an initial touch is no hit if the displacement leads away or along the surface.
/// Source: conservative advancement, see sweep.hpp; for a straight path it converges quadratically
std::optional<ConvexHit> castShape(const Convex& a, const Convex& b, const Frame& bInA, Vec2 displacement);

}  // namespace plumb::physics
