#pragma once

#include "physics/shapes/convex.hpp"

namespace plumb::physics {

/// How an outline filled with material resists being moved and turned.
struct MassProperties {
    float mass = 0.0f;     ///< kg
    Vec2 centre;           ///< m: the centre of mass; of what has no area, the middle
    float inertia = 0.0f;  ///< kg m2, about the centre of mass
};

/// Exact, round corners included: the core, a strip along each face and a sector at each corner.
/// @param density  kg/m2; nothing has mass below 0 or for NaN
MassProperties massOf(const Convex& convex, float density);

}  // namespace plumb::physics
