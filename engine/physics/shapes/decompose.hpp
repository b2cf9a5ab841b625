#pragma once

#include <vector>

#include "physics/shapes/hull.hpp"

namespace plumb::physics {

inline constexpr std::size_t kMaxOutline = 2048;  ///< points that decompose() takes

/// Cuts the inside of an outline into convex pieces: at most four times as many as are needed, none with
/// more than kMaxCorners corners. The outline may run either way round; it ends where it began by itself.
/// @error   it crosses or touches itself, turns back on itself, has no area, NaN or an absurd size
/// Source:  S. Hertel, K. Mehlhorn, "Fast triangulation of simple polygons", 1983; ears after G. Meisters,
/// 1975 Cost:    grows with the square of the points
Result<std::vector<Hull>> decompose(std::span<const Vec2> outline);

}  // namespace plumb::physics
