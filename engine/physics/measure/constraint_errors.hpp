#pragma once

#include "physics/world.hpp"

namespace plumb::physics {

// Constraint errors of contacts and joints, m, never negative.

/// Overlap of the two shapes of a contact at the start of the last step, without what initial_overlaps.cpp
/// hides. 0 for contacts that do not push.
[[nodiscard]] float overlapOf(const Contact& contact);

/// Current error of a joint: distance of its anchors, deviation of its length, excess over a limit; an angle
/// counts by how far it moves the anchor. Springs have no error, and gears and pulleys are not measured.
[[nodiscard]] float openingOf(const World& world, std::uint32_t joint);

}  // namespace plumb::physics
