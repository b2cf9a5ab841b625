#pragma once

#include "ecs/world.hpp"
#include "math/vec2.hpp"

namespace plumb {

/// Removes health points from an entity, unless it is dead or invulnerable after earlier damage.
/// @param knockback  px/s, velocity of the entity if it survives
/// @return false if it was not damaged
bool hurt(World& world, EntityId entity, int damage, Vec2 knockback);

/// Kills an entity with Health, even if it is invulnerable.
void kill(World& world, EntityId entity);

}  // namespace plumb
