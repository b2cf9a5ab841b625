#pragma once

#include "ecs/world.hpp"
#include "physics/settings.hpp"

namespace plumb {

// What physics_bridge and physics_queries share.

[[nodiscard]] bool hasColliders(const World& world);

/// The tolerances and gravity of a world, in metres.
[[nodiscard]] physics::Settings physicsSettingsOf(World& world);

}  // namespace plumb
