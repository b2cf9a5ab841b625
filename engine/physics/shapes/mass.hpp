#pragma once

#include "physics/shapes/convex.hpp"

namespace plumb::physics {

/// The mass properties of an outline filled with material.
struct MassProperties {
    float mass = 0.0f;     ///< kg
    Vec2 centre;           ///< m: the centre of mass; the geometric centre if there is no area
    float inertia = 0.0f;  ///< kg m2, about the centre of mass
};

/// Exact, rounded corners included: the sum of the core, a strip along each face and a sector at each corner.
/// @param density  kg/m2; negative values and NaN count as 0
MassProperties massOf(const Convex& convex, float density);

}  // namespace plumb::physics
