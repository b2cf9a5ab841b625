#pragma once

#include <optional>

#include "physics/queries/query.hpp"
#include "physics/shapes/convex.hpp"

namespace plumb::physics {

/// An outline that moves in a straight line, to be cast against shapes one at a time.
struct MovingOutline {
    Convex outline;
    WorldPosition position;  ///< m
    Rot rotation;
    Vec2 displacement;  ///< m: displacement
};

/// The first contact with a shape, if the shape's body is at `pose`.
std::optional<CastHit> meet(const World& world, std::uint32_t shape, const BodyPose& pose,
                            const MovingOutline& moving);

}  // namespace plumb::physics
