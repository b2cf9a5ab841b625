#pragma once

#include <span>

#include "physics/model/geometry.hpp"

namespace plumb::physics {

/// A fluid between surface and bottom, in its own frame: x along the surface, y down.
struct FluidBox {
    float half = 0.0f;   ///< m: half width, to both sides of the origin
    float depth = 0.0f;  ///< m
};

struct Submerged {
    float area = 0.0f;  ///< m2
    Vec2 centre;        ///< m: centroid, in the fluid's frame
};

/// Exact for every outline, rounded corners included.
/// @param toFluid  from the outline's frame to the fluid's
Submerged submergedPart(const Geometry& geometry, std::span<const Corner> corners, const Frame& toFluid,
                        const FluidBox& fluid);

}  // namespace plumb::physics
