#pragma once

#include <span>

#include "physics/effects/flyers.hpp"
#include "physics/settings.hpp"

namespace plumb::physics {

/// Moves all flyers of a group on by `substeps` steps of h (s), together, as they may pull each other. What
/// is steady is exact for all kinds; drag as well. Sources: E. Hairer, C. Lubich, G. Wanner, "Geometric
/// Numerical Integration", 2006, I.1; drag is split off as by G. Strang, 1968.
void integrate(const World& world, SmoothForces& forces, std::span<Flyer> flyers, IntegratorKind kind,
               float h, int substeps);

}  // namespace plumb::physics
