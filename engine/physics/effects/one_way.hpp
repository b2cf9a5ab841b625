#pragma once

#include "physics/world.hpp"

namespace plumb::physics {

/// Cosine of the angle between the open direction of a one-way shape and a normal that is its solid side.
inline constexpr float kSolidSide = 0.7f;

/// Whether the other body asks one-way shapes to let it through: kDropsThrough.
[[nodiscard]] bool dropsThrough(const World& world, const Contact& contact);

/// Whether a one-way shape lets the other one through, when they begin to touch: it comes from behind, or is
/// inside already. Both directions of a contact of two one-way shapes have to agree to stop them.
/// @param dt  s: how far back it looks, as bodies begin to touch with some overlap
[[nodiscard]] bool passesThrough(const World& world, const Contact& contact, float dt);

/// The same for a body that is swept along `way` (m) and is still outside: true when the shape does not stop
/// it.
[[nodiscard]] bool passesThrough(const World& world, std::uint32_t oneWayShape, Vec2 way);

}  // namespace plumb::physics
