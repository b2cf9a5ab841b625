#pragma once

#include "ecs/world.hpp"
#include "scene/physics/physics_state.hpp"

namespace plumb {

/// Fields follow their components, and the entities that have them.
/// @param all  an entity got or lost one
void followFields(World& world, PhysicsState& state, bool all);

/// Removes the components of explosions that have happened.
void removeExploded(World& world, PhysicsState& state);

/// Grows whenever some entity gets or loses a field.
[[nodiscard]] std::uint64_t fieldMembers(const World& world);

}  // namespace plumb
