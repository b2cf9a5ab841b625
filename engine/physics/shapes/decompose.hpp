#pragma once

#include <vector>

#include "physics/shapes/hull.hpp"

namespace plumb::physics {

inline constexpr std::size_t kMaxOutline = 2048;  ///< maximum number of points for decompose()

/// Splits the inside of an outline into convex pieces: at most four times as many as necessary, each with at
/// most kMaxCorners corners. The outline is closed implicitly and may be clockwise or counter-clockwise.
/// @error   it crosses or touches itself, turns back on itself, has no area, contains NaN or a size out of
/// range
/// Source:  S. Hertel, K. Mehlhorn, "Fast triangulation of simple polygons", 1983; ear clipping after G.
/// Meisters, 1975
/// Cost:    grows with the square of the number of points
Result<std::vector<Hull>> decompose(std::span<const Vec2> outline);

}  // namespace plumb::physics
