#pragma once

#include "ecs/world.hpp"
#include "scene/physics/physics_state.hpp"

namespace plumb {

/// Joints follow their components.
/// @param membersChanged    an entity got or lost a joint
/// @param bodiesCameOrWent  joints that wait for a body may find it
/// @param mark              what was written before it is known
void followJoints(World& world, PhysicsState& state, bool membersChanged, bool bodiesCameOrWent,
                  std::uint64_t mark);

/// Removes the components of joints that broke in the step, and tells.
void publishBroken(World& world, PhysicsState& state);

/// Grows whenever some entity gets or loses a joint.
[[nodiscard]] std::uint64_t jointMembers(const World& world);

}  // namespace plumb
