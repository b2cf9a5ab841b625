#pragma once

#include "physics/tuning.hpp"
#include "physics/world.hpp"

namespace plumb::physics {

/// True if the other body is set to fall through one-way shapes: kDropsThrough.
[[nodiscard]] bool dropsThrough(const World& world, const Contact& contact);

/// True if a one-way shape lets the other shape through when they begin to touch, because it comes from
/// behind or is already inside. In a contact of two one-way shapes both have to be solid.
/// @param dt  s: how far back it looks, as bodies begin to touch with some overlap
[[nodiscard]] bool passesThrough(const World& world, const Contact& contact, float dt);

/// The same for a body that starts outside and is swept by a displacement (m).
[[nodiscard]] bool passesThrough(const World& world, std::uint32_t oneWayShape, Vec2 displacement);

}  // namespace plumb::physics
