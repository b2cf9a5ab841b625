#pragma once

#include "ecs/world.hpp"
#include "scene/physics/physics_state.hpp"

namespace plumb {

/// Writes poses, velocities and `grounded` of the bodies that the step moved to their components.
void publishBodies(World& world, PhysicsState& state);

}  // namespace plumb
