#pragma once

#include "physics/world.hpp"

namespace plumb::physics {

// What tells how well a world is simulated. Computed when asked for: a step does not pay for it.

/// J: of motion, in the world's gravity, in springs and linear attractors, of all dynamic bodies. A world
/// without friction, drag and motors keeps it; what it gains or loses is the fault of the simulation.
[[nodiscard]] double energyOf(const World& world);

/// m: how deep two solid shapes are in each other at most, when the last step began; 0 where none are. What
/// initial_overlaps.hpp hides does not count.
[[nodiscard]] float deepestOverlapOf(const World& world);

/// m: how far a body of `world` is at most from where the same body of `other` is. Bodies that only one of
/// them has are left out.
[[nodiscard]] double largestDistanceOf(const World& world, const World& other);

}  // namespace plumb::physics
