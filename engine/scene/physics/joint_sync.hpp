#pragma once

#include "ecs/world.hpp"
#include "scene/physics/physics_state.hpp"

namespace plumb {

/// Updates the joints of the physics world from their components.
/// @param membersChanged    an entity gained or lost a joint component
/// @param bodiesCameOrWent  bodies were created or destroyed: joints that lacked a body may be created now
/// @param mark              change mark; only components written after it are visited
void followJoints(World& world, PhysicsState& state, bool membersChanged, bool bodiesCameOrWent,
                  std::uint64_t mark);

/// Removes the components of joints that broke in the step, and emits JointBroke events.
void publishBroken(World& world, PhysicsState& state);

/// Returns a counter that is incremented whenever an entity gains or loses a joint component.
[[nodiscard]] std::uint64_t jointMembers(const World& world);

}  // namespace plumb
