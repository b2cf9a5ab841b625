#pragma once

#include "ecs/world.hpp"
#include "scene/physics_state.hpp"

namespace plumb {

/// Joints follow their components.
/// @param all   somebody got or lost one, or a body
/// @param mark  what was written before it is known
void followJoints(World& world, PhysicsState& state, bool all, std::uint64_t mark);

/// Removes the components of joints that broke in the step, and tells.
void publishBroken(World& world, PhysicsState& state);

/// Grows whenever some entity gets or loses a joint.
[[nodiscard]] std::uint64_t jointMembers(const World& world);

}  // namespace plumb
