#pragma once

#include <span>

#include "core/fixed_list.hpp"
#include "core/result.hpp"
#include "physics/geometry.hpp"

namespace plumb::physics {

/// A convex polygon: its corners in the sense in which normals turn, each with the face that follows it.
struct Hull {
    FixedList<Corner, kMaxCorners> corners;
    Vec2 centroid;      ///< m
    float area = 0.0f;  ///< m2
};

/// The smallest convex polygon around some points, in any order. A corner that stands out by less than a
/// hundred-thousandth of the whole is left out: doubles, and points on a straight line.
/// The same points give the same corners whatever their order.
/// @error   less than 3 corners, no area, NaN, an absurd size, more than kMaxCorners corners
/// Source:  A. M. Andrew, "Another efficient algorithm for convex hulls in two dimensions", 1979
Result<Hull> makeHull(std::span<const Vec2> points);

/// The geometry of a hull whose corners are in World::corners from `first` on.
Geometry polygon(const Hull& hull, std::uint32_t first, float radius = 0.0f);

}  // namespace plumb::physics
