#pragma once

#include "ecs/world.hpp"

namespace plumb {

/// Returns the stereo position of a sound from its source's position in the view: -1 left .. 1 right; 0 if
/// the source has no position.
float panOf(const World& world, EntityId source);

}  // namespace plumb
