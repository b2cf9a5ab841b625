#pragma once

#include <cstdint>

#include "physics/shapes/convex.hpp"

namespace plumb::physics {

/// The final simplex of the last distance search between two outlines, from which the next search between
/// them starts. Any valid corner indices are allowed.
struct SimplexCache {
    std::uint8_t count = 0;
    std::uint8_t a[3] = {};
    std::uint8_t b[3] = {};
};

struct Distance {
    float distance = 0.0f;  ///< m between the surfaces; negative: penetration depth
    Vec2 normal;            ///< unit length, from A to B
    Vec2 pointA;            ///< m: point of A's surface nearest to B, or deepest inside B
    Vec2 pointB;
    int iterations = 0;  ///< iterations of GJK plus EPA
};

/// Computes the distance between two outlines, rounded corners included, in A's frame.
/// @param cache  start simplex; replaced by the final simplex
/// Source: E. Gilbert, D. Johnson, S. Keerthi, "A fast procedure for computing the distance between complex
/// objects in three-dimensional space", 1988 (GJK); overlaps after G. van den Bergen, "Proximity Queries and
/// Penetration Depth Computation on 3D Game Objects", GDC 2001 (expanding polytope, EPA)
Distance distanceBetween(const Convex& a, const Convex& b, const Frame& bInA, SimplexCache* cache = nullptr);

}  // namespace plumb::physics
