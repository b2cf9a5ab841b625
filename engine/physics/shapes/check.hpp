#pragma once

#include <span>

#include "core/result.hpp"
#include "physics/geometry.hpp"

namespace plumb::physics {

inline constexpr float kSmallestShape = 1.0e-4f;  ///< m: smaller ones drown in rounding
inline constexpr float kLargestShape = 1.0e6f;    ///< m: larger ones, or corners further off, as well

// What is wrong with a geometry of each kind; used by checkGeometry() of shape_types.hpp.
Result<Done> checkCircle(const Geometry& geometry, std::span<const Corner> corners);
Result<Done> checkCapsule(const Geometry& geometry, std::span<const Corner> corners);
Result<Done> checkBox(const Geometry& geometry, std::span<const Corner> corners);
Result<Done> checkPolygon(const Geometry& geometry, std::span<const Corner> corners);
Result<Done> checkSegment(const Geometry& geometry, std::span<const Corner> corners);

}  // namespace plumb::physics
