#pragma once

#include "ecs/world.hpp"
#include "box_physics/settings.hpp"

namespace plumb {

// What physics_bridge and physics_queries share.

[[nodiscard]] bool hasColliders(const World& world);

/// The tolerances and gravity of a world, in metres.
[[nodiscard]] box_physics::Settings physicsSettingsOf(World& world);

}  // namespace plumb
