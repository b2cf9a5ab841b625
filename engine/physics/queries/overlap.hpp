#pragma once

#include <optional>

#include "physics/queries/query.hpp"

namespace plumb::physics {

// Who is there. Answers are in the order of the shapes' numbers and replace what was in `found`; a shape that
// only touches counts. Numbers that are not finite or absurd find nothing.

/// Shapes that overlap an outline.
void overlapShape(World& world, const QueryShape& shape, const QueryFilter& filter,
                  std::vector<ShapeId>& found);
/// Shapes that overlap an upright box between its lowest and its highest corner (m).
void overlapBox(World& world, Place low, Place high, const QueryFilter& filter, std::vector<ShapeId>& found);
void overlapCircle(World& world, Place centre, float radius, const QueryFilter& filter,
                   std::vector<ShapeId>& found);
/// Shapes that a point is in. Nothing is inside a segment.
void overlapPoint(World& world, Place point, const QueryFilter& filter, std::vector<ShapeId>& found);

/// The place on the surface of a shape that is nearest to another.
struct ClosestHit {
    ShapeId shape;
    BodyId body;
    Place point;            ///< m
    Vec2 normal;            ///< length 1, out of the shape
    float distance = 0.0f;  ///< m; negative inside: how deep
};
/// The shape nearest to a place, and where on it; of equals the lowest number. Inside of several shapes, the
/// one that it is deepest in.
/// @param within  m: what is further away is not looked at; must be finite
std::optional<ClosestHit> closestPoint(World& world, Place place, float within,
                                       const QueryFilter& filter = {});

}  // namespace plumb::physics
