#pragma once

#include <optional>

#include "ecs/world.hpp"
#include "math/rect.hpp"
#include "scene/physics/physics_state.hpp"

namespace plumb {

struct SoftLook;

/// Creates ropes, cloth and jellies from their components. A
/// soft body whose component or position changes is recreated.
/// @param all  true if an entity gained or lost a soft body component
void followSoftBodies(World& world, PhysicsState& state, bool all);

/// Returns a counter that is incremented whenever an entity gains or loses a soft body component.
[[nodiscard]] std::uint64_t softMembers(const World& world);

/// True if the world has ropes, cloth or jellies.
[[nodiscard]] bool hasSoftBodies(const World& world);

/// Returns the bounds of an entity's soft bodies (px, world):
/// current, or initial if not created yet. nullopt if it has none.
[[nodiscard]] std::optional<AABB> softBounds(const World& world, EntityId entity);

/// Returns the component of a soft body; null if it was removed.
[[nodiscard]] const SoftLook* softLookOf(const World& world, const SoftLinkage& linkage);

}  // namespace plumb
