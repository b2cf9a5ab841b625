#pragma once

#include "physics/queries/query.hpp"
#include "physics/shapes/convex.hpp"

namespace plumb::physics {

// Shape casts: an outline moves in a straight line without rotating. Shapes that it overlaps at the start are
// hit at fraction 0. A shape that it only touches at the start is not hit if the displacement leads away or
// along the surface. A chain segment is only hit from its solid side. Invalid numbers hit nothing.

/// Finds the first shape hit; at equal distances the one with the lowest index.
std::optional<CastHit> castShape(World& world, const QueryShape& shape, Vec2 displacement,
                                 const QueryFilter& filter = {});
/// Finds all shapes hit, each once: nearest first; at equal distances the lowest index first.
void castShapeAll(World& world, const QueryShape& shape, Vec2 displacement, const QueryFilter& filter,
                  std::vector<CastHit>& hits);

/// An outline that moves in a straight line: argument of meet().
struct MovingOutline {
    Convex outline;
    WorldPosition position;  ///< m
    Rot rotation;
    Vec2 displacement;  ///< m
};

/// Casts the outline against a single shape whose body is at `pose`.
std::optional<CastHit> meet(const World& world, std::uint32_t shape, const BodyPose& pose,
                            const MovingOutline& moving);

}  // namespace plumb::physics
