#pragma once

#include <span>

#include "physics/effects/flyers.hpp"
#include "physics/settings.hpp"

namespace plumb::physics {

/// Advances all bodies of a group by `substeps` steps of h (s), together, as they may attract each other.
/// Under steady acceleration alone every scheme is exact. Drag is split off and exact too (G. Strang, 1968);
/// only Runge-Kutta evaluates slow drag with the other forces. Source: E. Hairer, C. Lubich, G. Wanner,
/// "Geometric Numerical Integration", 2006, I.1.
void integrate(const World& world, SmoothForces& forces, std::span<Flyer> flyers, IntegratorKind kind,
               float h, int substeps);

}  // namespace plumb::physics
