#pragma once

#include "ecs/world.hpp"
#include "scene/physics/physics_state.hpp"

namespace plumb {

/// Updates bodies, terrains, joints, fields and soft bodies from their components. Visits only components
/// written since the last call.
/// @param settings  settings of the physics world, in metres
void followComponents(World& world, PhysicsState& state, const physics::Settings& settings);

/// Returns the physics settings of a world, in metres: from
/// its PhysicsSettings, overridden by its ScenePhysics.
[[nodiscard]] physics::Settings physicsSettingsOf(World& world);

}  // namespace plumb
