#pragma once

#include <span>

#include "physics/geometry.hpp"

namespace plumb::physics {

struct Submerged {
    float area = 0.0f;   ///< m2
    Vec2 centre;         ///< m: centroid of the submerged area, in the fluid's frame
    float width = 0.0f;  ///< m: width of the whole outline along the surface
};

/// Computes the part of an outline inside a fluid, exact for every outline, rounded corners included.
/// @param toFluid  from the outline's frame to the fluid's: x along the surface, y down
/// @param fluid  m: box of the fluid in its own frame, from the surface, y = 0, to the bottom
Submerged submergedPart(const Geometry& geometry, std::span<const Corner> corners, const Frame& toFluid,
                        const AABB& fluid);

}  // namespace plumb::physics
