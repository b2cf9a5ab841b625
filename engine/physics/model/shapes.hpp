#pragma once

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
/// @return its first segment, which stands for the chain
Result<ShapeId> createChain(World& world, BodyId body, std::span<const Vec2> points, bool closed,
                            const ShapeDefinition& definition = {});
/// The same with a definition for each segment.
Result<ShapeId> createChain(World& world, BodyId body, std::span<const Vec2> points, bool closed,
                            std::span<const ShapeDefinition> definitions);
/// Finds the segments of a chain, given by any of them, in
/// order; none if it is gone. Replaces the content of `found`.
void segmentsOf(const World& world, ShapeId chain, std::vector<ShapeId>& found);
/// Destroys all segments of a chain, given by any of them.
void destroyChain(World& world, ShapeId chain);
/// Adds many shapes at once, each with its own definition: all of them, or none if one is invalid.
/// @error as createShape(), or a number of definitions that differs from that of outlines
Result<Done> createShapes(World& world, BodyId body, std::span<const Geometry> geometries,
                          std::span<const ShapeDefinition> definitions);
void destroyShapes(World& world, BodyId body);
/// Destroys a shape; its contacts end in the next step. A stale id does nothing.
void destroyShape(World& world, ShapeId shape);

/// Returns the null id for a shape that is gone.
[[nodiscard]] BodyId bodyOf(const World& world, ShapeId shape);

// Edits of an existing shape. The body behaves as if the shape had been created so: masses are
// updated, and bodies that rest on it wake. Contacts that a new outline, trigger flag or one-way
// direction affects start again: the next step reports Ended, and Began for what still touches.

/// Replaces the outline by another of any kind; setPolygon() by the convex hull of the points (m).
Result<Done> setGeometry(World& world, ShapeId shape, const Geometry& geometry);
Result<Done> setPolygon(World& world, ShapeId shape, std::span<const Vec2> points, float radius = 0.0f);
/// Returns a default definition for a shape that is gone.
[[nodiscard]] ShapeDefinition definitionOf(const World& world, ShapeId shape);
/// Replaces material, filter and the rest; only `surface` must stay the same. See also change().
Result<Done> setDefinition(World& world, ShapeId shape, const ShapeDefinition& definition);

/// Changes members of the definition of a shape or joint: change(world, shape, [](auto& d) { d.density = 2;
/// }).
template <class Thing, class Change>
Result<Done> change(World& world, Id<Thing> id, Change&& change) {
    if (!alive(world, id)) return setDefinition(world, id, {});  // returns the error
    auto definition = definitionOf(world, id);
    change(definition);
    return setDefinition(world, id, definition);
}

inline Result<Done> setFriction(World& world, ShapeId shape, float friction) {  ///< 0..100
    return change(world, shape, [&](ShapeDefinition& definition) { definition.friction = friction; });
}
inline Result<Done> setBounciness(World& world, ShapeId shape, float bounciness) {  ///< 0..1
    return change(world, shape, [&](ShapeDefinition& definition) { definition.bounciness = bounciness; });
}
inline Result<Done> setSurfaceSpeed(World& world, ShapeId shape, float speed) {  ///< m/s
    return change(world, shape, [&](ShapeDefinition& definition) { definition.surfaceSpeed = speed; });
}
void setFilter(World& world, ShapeId shape, std::uint32_t layers, std::uint32_t mask, std::int32_t group);

}  // namespace plumb::physics
