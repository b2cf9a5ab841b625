#pragma once

#include <span>

#include "physics/geometry.hpp"

namespace plumb::physics {

/// A fluid between its surface and its bottom, in a frame of its own: x along the surface, y down from it.
struct FluidBox {
    float half = 0.0f;   ///< m: it ends this far on both sides of the origin
    float depth = 0.0f;  ///< m
};

/// The part of an outline that is in a fluid.
struct Submerged {
    float area = 0.0f;  ///< m2
    Vec2 centre;        ///< m, in the fluid's frame
};

/// Exact for every outline, round corners included.
/// @param toFluid  from the outline's frame to the fluid's
Submerged submergedPart(const Geometry& geometry, std::span<const Corner> corners, const Frame& toFluid,
                        const FluidBox& fluid);

}  // namespace plumb::physics
