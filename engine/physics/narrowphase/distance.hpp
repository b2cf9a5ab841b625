#pragma once

#include <cstdint>

#include "physics/shapes/convex.hpp"

namespace plumb::physics {

/// Which corners were nearest: where the next search between the same outlines begins. Any content is valid.
struct SimplexCache {
    std::uint8_t count = 0;
    std::uint8_t a[3] = {};
    std::uint8_t b[3] = {};
};

struct Distance {
    float distance = 0.0f;  ///< m between the surfaces; negative: how deep they are inside each other
    Vec2 normal;            ///< length 1, from A to B
    Vec2 pointA;            ///< m: on A's surface, nearest to B, or deepest inside of it
    Vec2 pointB;
    int iterations = 0;  ///< of both searches
};

/// How far two outlines are apart, in A's frame, round corners included.
/// @param cache  where to begin; afterwards, where this search ended
/// Source: E. Gilbert, D. Johnson, S. Keerthi, "A fast procedure for computing the distance between complex
///         objects in three-dimensional space", 1988; overlaps after G. van den Bergen, "Proximity Queries
///         and Penetration Depth Computation on 3D Game Objects", GDC 2001 (expanding polytope)
Distance distanceBetween(const Convex& a, const Convex& b, const Frame& bInA, SimplexCache* cache = nullptr);

}  // namespace plumb::physics
