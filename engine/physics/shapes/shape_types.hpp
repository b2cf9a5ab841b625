#pragma once

#include <optional>
#include <string_view>

#include "core/result.hpp"
#include "physics/shapes/mass.hpp"
#include "physics/shapes/probe.hpp"

namespace plumb::physics {

/// What the kinds of outlines do differently. `corners` is World::corners everywhere.
struct ShapeType {
    std::string_view name;
    bool solid = true;  ///< has an inside, and so a mass
    AABB (*bounds)(const Geometry& geometry, std::span<const Corner> corners, const Frame& frame) = nullptr;
    std::optional<RayHit> (*castRay)(const Geometry& geometry, std::span<const Corner> corners,
                                     const Ray& ray) = nullptr;
    Result<Done> (*check)(const Geometry& geometry, std::span<const Corner> corners) = nullptr;
};

const ShapeType& shapeTypeOf(ShapeKind kind);

/// @error  a member is NaN, infinite, or of an absurd size; a polygon is not convex, or not in the pool
Result<Done> checkGeometry(const Geometry& geometry, std::span<const Corner> corners);

/// @param density  kg/m2; below 0 and NaN count as 0
MassProperties massProperties(const Geometry& geometry, std::span<const Corner> corners, float density);

/// The smallest box around the outline, in the frame's surroundings (m).
AABB boundsOf(const Geometry& geometry, std::span<const Corner> corners, const Frame& frame);

/// m: no point of the outline is further from `from`.
float reachOf(const Geometry& geometry, std::span<const Corner> corners, Vec2 from);

/// m: a disc of this radius around `at` is inside the outline; 0 when `at` itself is not.
float coreOf(const Geometry& geometry, std::span<const Corner> corners, Vec2 at);

/// The edge of the outline counts as inside; nothing is inside a segment.
bool containsPoint(const Geometry& geometry, std::span<const Corner> corners, Vec2 point);

ClosestPoint closestPoint(const Geometry& geometry, std::span<const Corner> corners, Vec2 place);

/// Where a ray enters; at 0 when it starts inside. A chain segment is only hit on its solid side.
std::optional<RayHit> castRay(const Geometry& geometry, std::span<const Corner> corners, const Ray& ray);

}  // namespace plumb::physics
