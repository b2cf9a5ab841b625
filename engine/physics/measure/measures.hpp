#pragma once

#include "physics/world.hpp"

namespace plumb::physics {

// Measures of the quality of a simulation. Computed only by calls of these functions, not in each step.

/// Returns the energy (J) of all dynamic bodies: kinetic, and potential in the world's gravity, springs and
/// linear attractors. Without friction, drag and motors any change of it is an error of the simulation.
[[nodiscard]] double energyOf(const World& world);

/// Returns the maximum overlap (m) of two solid shapes at the start of the last step; 0 if there is none.
/// Overlap hidden by initial_overlaps.cpp does not count.
[[nodiscard]] float deepestOverlapOf(const World& world);

/// Returns the maximum distance (m) of a dynamic body from the same body in `other`, if it exists in both.
[[nodiscard]] double largestDistanceOf(const World& world, const World& other);

// Constraint errors of contacts and joints, m, never negative.

/// Returns the overlap of the two shapes of a contact at the start of the last step, without overlap hidden
/// by initial_overlaps.cpp. 0 for contacts that exert no forces.
[[nodiscard]] inline float overlapOf(const Contact& contact) {
    if ((contact.flags & (kTouching | kTriggered | kDisabled)) != kTouching) return 0.0f;
    return std::max(0.0f, -std::min(contact.separation0, contact.separation1));
}

/// Returns the current error of a joint: distance of its anchors, deviation from its length or excess over a
/// limit; for angles, the displacement that they cause. 0 for springs, gears and pulleys.
[[nodiscard]] float openingOf(const World& world, std::uint32_t joint);

}  // namespace plumb::physics
