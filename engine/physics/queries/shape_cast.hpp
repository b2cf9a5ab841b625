#pragma once

#include "physics/queries/query.hpp"
#include "physics/shapes/convex.hpp"

namespace plumb::physics {

// Shape casts: an outline moves in a straight line without rotating. It hits shapes that it overlaps at the
// start at fraction 0. It does not hit a shape that it only touches there if the displacement leads away or
// along the surface. A chain segment is only hit from its solid side. Values that are not finite or out of
// range hit nothing.

/// The first shape hit; at equal distances the one with the lowest index.
std::optional<CastHit> castShape(World& world, const QueryShape& shape, Vec2 displacement,
                                 const QueryFilter& filter = {});
/// All shapes hit, each once: nearest first; at equal distances the lowest index first.
void castShapeAll(World& world, const QueryShape& shape, Vec2 displacement, const QueryFilter& filter,
                  std::vector<CastHit>& hits);

/// An outline that moves in a straight line, to be cast against shapes one at a time.
struct MovingOutline {
    Convex outline;
    WorldPosition position;  ///< m
    Rot rotation;
    Vec2 displacement;  ///< m
};

/// The first contact with a shape, if the shape's body is at `pose`.
std::optional<CastHit> meet(const World& world, std::uint32_t shape, const BodyPose& pose,
                            const MovingOutline& moving);

}  // namespace plumb::physics
