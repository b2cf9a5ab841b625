#pragma once

#include "ecs/world.hpp"
#include "scene/physics/physics_state.hpp"

namespace plumb {

/// Updates the fields of the physics world from their components and entities.
/// @param all  true if an entity gained or lost a field component
void followFields(World& world, PhysicsState& state, bool all);

/// Removes the components of explosions that have taken effect.
void removeExploded(World& world, PhysicsState& state);

/// Returns a counter that is incremented whenever an entity gains or loses a field component.
[[nodiscard]] std::uint64_t fieldMembers(const World& world);

}  // namespace plumb
