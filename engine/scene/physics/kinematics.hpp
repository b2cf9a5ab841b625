#pragma once

#include "ecs/world.hpp"
#include "scene/physics/physics_state.hpp"

namespace plumb {

/// Sets the motion of kinematic bodies in the next step: to the pose of their Transform if it was changed in
/// this tick, otherwise by their velocity. May be called several times before the step.
/// @param dt  s, length of the tick
void driveKinematics(World& world, PhysicsState& state, float dt);

}  // namespace plumb
