#pragma once

#include "ecs/world.hpp"
#include "scene/physics/physics_state.hpp"

namespace plumb {

/// Bodies, terrains, joints and fields follow their components. Looks only at what was written since the last
/// time.
/// @param settings  of the world, in metres
void followComponents(World& world, PhysicsState& state, const physics::Settings& settings);

/// The tolerances and gravity of a world, in metres: those of its ScenePhysics, or else its PhysicsSettings.
[[nodiscard]] physics::Settings physicsSettingsOf(World& world);

}  // namespace plumb
