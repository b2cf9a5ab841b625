#pragma once

#include "ecs/world.hpp"

namespace plumb {

/// From where in its scene's picture a sound comes, -1 left .. 1 right; 0 for one without a place.
float panOf(const World& world, EntityId source);

}  // namespace plumb
