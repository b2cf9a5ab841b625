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
/// Adds a chain of segments, solid on one side (see normalOfChain); bodies slide over its vertices without
/// catching. The first and last point of an open chain are ghost vertices: they define where its ends point.
/// @error fewer than 3 points (closed) or 4 (open), coincident points, a number that is not finite
/// @param definitions  one for each segment, or one for all
/// @return its first segment, whose id identifies the chain
Result<ShapeId> createChain(World& world, BodyId body, std::span<const Vec2> points, bool closed,
                            std::span<const ShapeDefinition> definitions);
inline Result<ShapeId> createChain(World& world, BodyId body, std::span<const Vec2> points, bool closed,
                                   const ShapeDefinition& definition = {}) {
    return createChain(world, body, points, closed, std::span{&definition, 1});
}
/// Replaces `found` by the segments of a chain, in order, from the id of any segment; empty for a stale id.
void segmentsOf(const World& world, ShapeId chain, std::vector<ShapeId>& found);
/// Destroys all segments of a chain; `chain` is the id of any segment.
void destroyChain(World& world, ShapeId chain);
/// Adds many shapes at once, each with its own definition; adds none if one is invalid.
/// @error the same errors as createShape(), or different numbers of outlines and definitions
Result<Done> createShapes(World& world, BodyId body, std::span<const Geometry> geometries,
                          std::span<const ShapeDefinition> definitions);
void destroyShapes(World& world, BodyId body);
/// Destroys a shape; its contacts end in the next step. A stale id does nothing.
void destroyShape(World& world, ShapeId shape);

/// Returns the body of a shape, or the null id if the shape was destroyed.
[[nodiscard]] inline BodyId bodyOf(const World& world, ShapeId shape) {
    const std::uint32_t body = readOf(world, world.shapes.info, shape).body;
    return body == kNone ? BodyId{} : idOfBody(world, body);
}

// Edits of an existing shape. The result is as if the shape had been created with the new values: masses are
// updated, and bodies that rest on it wake. Contacts affected by a new outline, trigger flag or one-way
// direction restart: the next step reports Ended, and Began for shapes that still touch.

/// Replaces the outline; it may have another kind. setPolygon() uses the convex hull of the points (m).
Result<Done> setGeometry(World& world, ShapeId shape, const Geometry& geometry);
Result<Done> setPolygon(World& world, ShapeId shape, std::span<const Vec2> points, float radius = 0.0f);
/// Returns the definition of a shape, or the default if the shape was destroyed.
[[nodiscard]] ShapeDefinition definitionOf(const World& world, ShapeId shape);
/// Replaces material, filter and all other members except `surface`, which cannot change. See also change().
Result<Done> setDefinition(World& world, ShapeId shape, const ShapeDefinition& definition);

/// Changes the definition of a shape or joint: change(world, shape, [](auto& d) { d.density = 2; }).
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
