#pragma once

#include <optional>

#include "physics/shapes/convex.hpp"

namespace plumb::physics {

/// The point of an outline's edge that is nearest to a place.
struct ClosestPoint {
    Vec2 point;             ///< m
    Vec2 normal;            ///< length 1, out of the outline at that point
    float distance = 0.0f;  ///< m; negative inside
    bool atCorner = false;  ///< the nearest part is a corner, round or sharp, and not a face
};

ClosestPoint closestPointOf(const Convex& convex, Vec2 place);

/// A straight line from `from` to `from + way`.
struct Ray {
    Vec2 from;  ///< m
    Vec2 way;   ///< m
};

struct RayHit {
    float fraction = 0.0f;  ///< ratio of the way, 0..1
    Vec2 normal;            ///< length 1, out of the outline
};

/// Where a ray enters an outline; at 0 when it starts inside.
std::optional<RayHit> castRayAt(const Convex& convex, const Ray& ray);

}  // namespace plumb::physics
