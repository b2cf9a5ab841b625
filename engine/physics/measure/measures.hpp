#pragma once

#include "physics/world.hpp"

namespace plumb::physics {

// Measures of the quality of a simulation. Computed on request: a step does not pay for them.

/// J: of all dynamic bodies, kinetic and in the world's gravity, springs and linear attractors. A world
/// without friction, drag and motors conserves it; any change is an error of the simulation.
[[nodiscard]] double energyOf(const World& world);

/// m: maximum overlap of two solid shapes at the start of the last step; 0 if there is none. What
/// initial_overlaps.cpp hides does not count.
[[nodiscard]] float deepestOverlapOf(const World& world);

/// m: maximum distance of a dynamic body of `world` from the same body of `other`. Bodies of one alone do not
/// count.
[[nodiscard]] double largestDistanceOf(const World& world, const World& other);

// Constraint errors of contacts and joints, m, never negative.

/// Overlap of the two shapes of a contact at the start of the last step, without what initial_overlaps.cpp
/// hides. 0 for contacts that do not push.
[[nodiscard]] float overlapOf(const Contact& contact);

/// Current error of a joint: distance of its anchors, deviation of its length, excess over a limit; an angle
/// counts by how far it moves the anchor. Springs have no error, and gears and pulleys are not measured.
[[nodiscard]] float openingOf(const World& world, std::uint32_t joint);

}  // namespace plumb::physics
