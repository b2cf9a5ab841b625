#pragma once

#include <span>

#include "core/result.hpp"
#include "physics/model/geometry.hpp"

namespace plumb::physics {

// Validation of a geometry of each kind; used by checkGeometry() of shape_types.hpp.
Result<Done> checkCircle(const Geometry& geometry, std::span<const Corner> corners);
Result<Done> checkCapsule(const Geometry& geometry, std::span<const Corner> corners);
Result<Done> checkBox(const Geometry& geometry, std::span<const Corner> corners);
Result<Done> checkPolygon(const Geometry& geometry, std::span<const Corner> corners);
Result<Done> checkSegment(const Geometry& geometry, std::span<const Corner> corners);

}  // namespace plumb::physics
