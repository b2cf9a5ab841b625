#pragma once

#include <string_view>

#include "core/result.hpp"
#include "physics/shapes/mass.hpp"
#include "physics/shapes/probe.hpp"

namespace plumb::physics {

/// The functions that differ between kinds of outlines. `corners` is Shapes::corners everywhere.
struct ShapeType {
    std::string_view name;
    bool solid = true;  ///< it has an inside, and so a mass
    AABB (*bounds)(const Geometry& geometry, std::span<const Corner> corners, const Frame& frame) = nullptr;
};

const ShapeType& shapeTypeOf(ShapeKind kind);

/// @error  a member is NaN, infinite or out of range; a polygon is not convex, or not in the pool
Result<Done> checkGeometry(const Geometry& geometry, std::span<const Corner> corners);

/// @param density  kg/m2; negative values and NaN count as 0
MassProperties massProperties(const Geometry& geometry, std::span<const Corner> corners, float density);

/// The bounding box of the outline, in the parent space of `frame` (m).
AABB boundsOf(const Geometry& geometry, std::span<const Corner> corners, const Frame& frame);

/// m: maximum distance of a point of the outline from `from`.
float reachOf(const Geometry& geometry, std::span<const Corner> corners, Vec2 from);

/// m: radius of the largest disc around `at` inside the outline; 0 if `at` is outside.
float coreOf(const Geometry& geometry, std::span<const Corner> corners, Vec2 at);

/// The boundary counts as inside; a segment has no inside.
bool containsPoint(const Geometry& geometry, std::span<const Corner> corners, Vec2 point);

ClosestPoint closestPoint(const Geometry& geometry, std::span<const Corner> corners, Vec2 place);

/// The point at which a ray enters; fraction 0 if it starts inside. A chain segment is only hit on its solid
/// side.
std::optional<RayHit> castRay(const Geometry& geometry, std::span<const Corner> corners, const Ray& ray);

}  // namespace plumb::physics
