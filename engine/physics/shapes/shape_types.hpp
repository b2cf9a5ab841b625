#pragma once

#include <optional>
#include <string_view>

#include "core/result.hpp"
#include "physics/shapes/convex.hpp"

namespace plumb::physics {

/// The functions that differ between kinds of outlines. `corners` is Shapes::corners everywhere.
struct ShapeType {
    std::string_view name;
    bool solid = true;  ///< it has an area, and therefore a mass
    AABB (*bounds)(const Geometry& geometry, std::span<const Corner> corners, const Frame& frame) = nullptr;
    Result<Done> (*check)(const Geometry& geometry, std::span<const Corner> corners) = nullptr;
};

const ShapeType& shapeTypeOf(ShapeKind kind);

/// @error  a member is NaN, infinite or out of range; a polygon is not convex, or not in `corners`
Result<Done> checkGeometry(const Geometry& geometry, std::span<const Corner> corners);

/// Computes exact mass properties, including rounded corners.
/// @param density  kg/m2; negative values and NaN count as 0
MassProperties massProperties(const Geometry& geometry, std::span<const Corner> corners, float density);

/// Returns the bounding box (m) of the outline in the parent space of `frame`.
inline AABB boundsOf(const Geometry& geometry, std::span<const Corner> corners, const Frame& frame) {
    return shapeTypeOf(geometry.kind).bounds(geometry, corners, frame);
}

/// Returns the maximum distance (m) of a point of the outline from `from`.
float reachOf(const Geometry& geometry, std::span<const Corner> corners, Vec2 from);

/// The point on the boundary of an outline that is nearest to a given point.
struct ClosestPoint {
    Vec2 point;             ///< m
    Vec2 normal;            ///< unit length, outward at that point
    float distance = 0.0f;  ///< m; negative inside
    bool atCorner = false;  ///< the nearest feature is a corner, rounded or sharp, not a face
    std::size_t index = 0;  ///< index of this corner, or of the start of the face
};

ClosestPoint closestPointOf(const Convex& convex, Vec2 place);
inline ClosestPoint closestPoint(const Geometry& geometry, std::span<const Corner> corners, Vec2 place) {
    return closestPointOf(convexOf(geometry, corners), place);
}

/// Returns the radius (m) of the largest disc around `at` inside the outline; 0 if `at` is outside.
inline float coreOf(const Geometry& geometry, std::span<const Corner> corners, Vec2 at) {
    return std::max(0.0f, -closestPoint(geometry, corners, at).distance);
}
/// True if the outline contains the point. The boundary counts as inside; a segment has no inside.
inline bool containsPoint(const Geometry& geometry, std::span<const Corner> corners, Vec2 point) {
    return shapeTypeOf(geometry.kind).solid && closestPoint(geometry, corners, point).distance <= 0.0f;
}

/// A line segment from `from` to `from + displacement`.
struct Ray {
    Vec2 from;          ///< m
    Vec2 displacement;  ///< m
};

struct RayHit {
    float fraction = 0.0f;  ///< fraction of the displacement, 0..1
    Vec2 normal;            ///< unit length, outward
};

/// Finds the point at which a ray enters; fraction 0 if it starts inside. Chains: only from the front.
std::optional<RayHit> castRay(const Geometry& geometry, std::span<const Corner> corners, const Ray& ray);

}  // namespace plumb::physics
