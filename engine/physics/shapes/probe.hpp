#pragma once

#include <optional>

#include "physics/shapes/convex.hpp"

namespace plumb::physics {

/// The point on the boundary of an outline that is nearest to a given point.
struct ClosestPoint {
    Vec2 point;             ///< m
    Vec2 normal;            ///< unit length, outward at that point
    float distance = 0.0f;  ///< m; negative inside
    bool atCorner = false;  ///< the nearest feature is a corner, rounded or sharp, not a face
    std::size_t index = 0;  ///< of that corner, or of the one at which the face starts
};

ClosestPoint closestPointOf(const Convex& convex, Vec2 place);

/// A line segment from `from` to `from + way`.
struct Ray {
    Vec2 from;          ///< m
    Vec2 displacement;  ///< m: displacement
};

struct RayHit {
    float fraction = 0.0f;  ///< fraction of the displacement, 0..1
    Vec2 normal;            ///< unit length, outward
};

/// The point at which a ray enters an outline; fraction 0 if it starts inside.
std::optional<RayHit> castRayAt(const Convex& convex, const Ray& ray);

}  // namespace plumb::physics
