#pragma once

#include "ecs/world.hpp"
#include "scene/physics_state.hpp"

namespace plumb {

struct SoftLook;

/// Ropes, cloth and jellies are made where their components say. One whose component or place changes is made
/// anew.
/// @param all  somebody got or lost one
void followSoftBodies(World& world, PhysicsState& state, bool all);

/// Grows whenever some entity gets or loses a soft body.
[[nodiscard]] std::uint64_t softMembers(const World& world);

/// The component behind a soft body; nullptr when it is gone.
[[nodiscard]] const SoftLook* softLookOf(const World& world, const SoftLinkage& linkage);

}  // namespace plumb
