#pragma once

#include "ecs/world.hpp"
#include "math/vec2.hpp"

namespace plumb {

/// Takes health from an entity, unless it is dead or still safe from the last time.
/// @param knockback  px/s, its new velocity if it lives on
/// @return false when it was not hurt
bool hurt(World& world, EntityId entity, int damage, Vec2 knockback);

/// Takes all of its health, safe or not.
void kill(World& world, EntityId entity);

}  // namespace plumb
