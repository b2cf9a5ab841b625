#pragma once

#include "physics/world.hpp"

namespace plumb::physics {

// How far contacts and joints are from what they should keep to, m. Both are 0 at best and never below.

/// How deep the two shapes of a contact were in each other at the start of the last step, without what is
/// left alone (initial_overlaps.hpp). 0 for contacts that do not push.
[[nodiscard]] float overlapOf(const Contact& contact);

/// How far a joint is open now: apart, of the wrong length, beyond a limit; an angle counts by how far it
/// moves the anchor. What springs is never wrong, and gears and pulleys are not measured.
[[nodiscard]] float openingOf(const World& world, std::uint32_t joint);

}  // namespace plumb::physics
