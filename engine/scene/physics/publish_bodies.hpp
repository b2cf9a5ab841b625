#pragma once

#include "ecs/world.hpp"
#include "scene/physics/physics_state.hpp"

namespace plumb {

/// Poses, velocities and `grounded` back into the components of bodies that the step moved.
void publishBodies(World& world, PhysicsState& state);

}  // namespace plumb
