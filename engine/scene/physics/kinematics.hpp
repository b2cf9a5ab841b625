#pragma once

#include "ecs/world.hpp"
#include "scene/physics/physics_state.hpp"

namespace plumb {

/// Sends kinematic bodies on their way through the next step: to where their Transform was put in this tick,
/// or else as their velocity says. May be called several times before the step.
/// @param dt  s
void driveKinematics(World& world, PhysicsState& state, float dt);

}  // namespace plumb
