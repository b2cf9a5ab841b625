#pragma once

#include <optional>

#include "physics/queries/query.hpp"
#include "physics/shapes/convex.hpp"

namespace plumb::physics {

/// An outline on its straight way, for a cast against one shape after the other.
struct MovingOutline {
    Convex outline;
    Place position;  ///< m
    Rot rotation;
    Vec2 way;  ///< m
};

/// Where it meets one shape, if the shape's body is at `pose`.
std::optional<CastHit> meet(const World& world, std::uint32_t shape, const BodyPose& pose,
                            const MovingOutline& moving);

}  // namespace plumb::physics
