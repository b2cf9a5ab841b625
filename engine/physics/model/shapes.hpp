#pragma once

#include <span>

#include "core/result.hpp"
#include "physics/world.hpp"

namespace plumb::physics {

/// Adds a circle, capsule, box or segment (geometry.hpp) to a body and updates the body's mass.
/// @error a number that is not finite, a size that is not positive or out of range, a stale body
Result<ShapeId> createShape(World& world, BodyId body, const Geometry& geometry,
                            const ShapeDefinition& definition = {});
/// Adds the convex hull of the points (m, in the body's frame), with corners rounded by `radius`.
/// @error points without area, too many corners (kMaxCorners), a number that is not finite
Result<ShapeId> createPolygon(World& world, BodyId body, std::span<const Vec2> points, float radius = 0.0f,
                              const ShapeDefinition& definition = {});
/// Adds a chain of segments, solid on one side (see normalOfChain); bodies slide over its joints without
/// catching. The first and the last point of an open chain are ghost vertices: they only define the direction
/// in which it would go on.
/// @error fewer than 3 points (closed) or 4 (open), coincident points, a number that is not finite
Result<Done> createChain(World& world, BodyId body, std::span<const Vec2> points, bool closed,
                         const ShapeDefinition& definition = {});
/// Adds many shapes at once, each with its own definition: all of them, or none if one is invalid.
/// @error as createShape(), or a number of definitions that differs from that of outlines
Result<Done> createShapes(World& world, BodyId body, std::span<const Geometry> geometries,
                          std::span<const ShapeDefinition> definitions);
/// Destroys all shapes of a body.
void destroyShapes(World& world, BodyId body);
/// Destroys a shape; its contacts end in the next step. A stale id does nothing.
void destroyShape(World& world, ShapeId shape);

[[nodiscard]] bool alive(const World& world, ShapeId shape);
[[nodiscard]] BodyId bodyOf(const World& world, ShapeId shape);

Result<Done> setFriction(World& world, ShapeId shape, float friction);      ///< 0..100
Result<Done> setBounciness(World& world, ShapeId shape, float bounciness);  ///< 0..1
Result<Done> setSurfaceSpeed(World& world, ShapeId shape, float speed);     ///< m/s
void setFilter(World& world, ShapeId shape, std::uint32_t layers, std::uint32_t mask, std::int32_t group);

}  // namespace plumb::physics
