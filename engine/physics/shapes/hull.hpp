#pragma once

#include <span>
#include <vector>

#include "core/fixed_list.hpp"
#include "core/result.hpp"
#include "physics/geometry.hpp"

namespace plumb::physics {

/// A convex polygon: its corners in the direction of rotation from x to y, as in Corner.
struct Hull {
    FixedList<Corner, kMaxCorners> corners;
    Vec2 centroid;      ///< m
    float area = 0.0f;  ///< m2
};

/// Computes the convex hull of points, in any order. Corners that protrude by less than a hundred-thousandth
/// of the size of the hull are omitted: duplicates, and points on a straight line.
/// @error   fewer than 3 corners, no area, NaN, a size out of range, more than kMaxCorners corners
/// Source:  A. M. Andrew, "Another efficient algorithm for convex hulls in two dimensions", 1979
Result<Hull> makeHull(std::span<const Vec2> points);

inline constexpr std::size_t kMaxOutline = 2048;  ///< maximum number of points for decompose()

/// Splits the inside of an outline into convex pieces: at most four times as many as necessary, each with at
/// most kMaxCorners corners. The outline is closed implicitly and may be clockwise or counter-clockwise.
/// @error   it crosses or touches itself, turns back on itself, has no area, NaN or a size out of range
/// Source:  S. Hertel, K. Mehlhorn, "Fast triangulation of simple polygons", 1983; ear clipping after G.
/// Meisters, 1975
/// Cost:    grows with the square of the number of points
Result<std::vector<Hull>> decompose(std::span<const Vec2> outline);

/// Returns the geometry of a hull whose corners are in Shapes::corners from `first` on.
inline Geometry polygon(const Hull& hull, std::uint32_t first, float radius = 0.0f) {
    return {.kind = ShapeKind::Polygon,
            .count = static_cast<std::uint8_t>(hull.corners.size()),
            .first = first,
            .radius = radius,
            .a = hull.centroid,
            .b = {}};
}

}  // namespace plumb::physics
