#pragma once

#include <cstdint>

#include "math/vec2.hpp"

namespace plumb::physics {

/// One place where two outlines touch or nearly do.
struct ManifoldPoint {
    Vec2 point;               ///< m, in the frame of the first: midway between the two surfaces
    float separation = 0.0f;  ///< m along the normal; negative inside each other
    std::uint16_t id = 0;     ///< which features meet: the same id a step later is the same place
};

/// Where and along which direction two outlines meet.
struct Manifold {
    Vec2 normal;  ///< length 1, in the frame of the first, from the first to the second
    ManifoldPoint points[2];
    int count = 0;  ///< 0: further apart than was asked for
    /// m: radius of the round feature of each side at these points; 0 where a face or a corner touches.
    /// A round thing may turn under its contact point without moving it.
    float roundA = 0.0f;
    float roundB = 0.0f;
};

}  // namespace plumb::physics
