#pragma once

#include <cstdint>

#include "math/vec2.hpp"

namespace plumb::physics {

/// A point at which two outlines touch or nearly touch.
struct ManifoldPoint {
    Vec2 point;               ///< m, in the frame of the first outline: midway between the two surfaces
    float separation = 0.0f;  ///< m along the normal; negative: overlap
    std::uint16_t id = 0;     ///< of the touching features: an equal id in the next step is the same point
};

/// The contact points of two outlines and their common normal.
struct Manifold {
    Vec2 normal;  ///< unit length, in the frame of the first outline, from the first to the second
    ManifoldPoint points[2];
    int count = 0;  ///< 0: the outlines are further apart than the limit
    /// m: radius of the round feature of each outline at these points; 0 for a face or a sharp corner. A
    /// round feature can rotate about its centre without moving the contact point.
    float roundA = 0.0f;
    float roundB = 0.0f;
};

}  // namespace plumb::physics
