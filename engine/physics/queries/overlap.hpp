#pragma once

#include "physics/queries/query.hpp"

namespace plumb::physics {

// Overlap queries. Results replace the content of `found`, in ascending order of shape indices; a shape that
// only touches is included. Values that are not finite or out of range give an empty result.

void overlapShape(World& world, const QueryShape& shape, const QueryFilter& filter,
                  std::vector<ShapeId>& found);
/// Finds the shapes that overlap an axis-aligned box between its lower and upper corner (m). A box with more
/// than twice kLargest on a side finds them by their bounds.
void overlapBox(World& world, WorldPosition low, WorldPosition high, const QueryFilter& filter,
                std::vector<ShapeId>& found);
inline void overlapCircle(World& world, WorldPosition centre, float radius, const QueryFilter& filter,
                          std::vector<ShapeId>& found) {
    overlapShape(world, {.geometry = circle(radius), .position = centre, .rotation = {}}, filter, found);
}
/// Finds the shapes that contain a point. A segment has no inside.
void overlapPoint(World& world, WorldPosition point, const QueryFilter& filter, std::vector<ShapeId>& found);

/// The point on the surface of a shape that is nearest to a given point.
struct ClosestHit {
    ShapeId shape;
    BodyId body;
    WorldPosition point;    ///< m
    Vec2 normal;            ///< unit length, outward from the shape
    float distance = 0.0f;  ///< m; negative: depth inside the shape
};
/// Finds the shape nearest to a point; at equal distances the lowest index. If the point is inside several
/// shapes, the one in which it is deepest.
/// @param within  m: maximum distance; must be finite
std::optional<ClosestHit> closestPoint(World& world, WorldPosition place, float within,
                                       const QueryFilter& filter = {});

}  // namespace plumb::physics
