#pragma once

#include <optional>

#include "ecs/world.hpp"
#include "math/rect.hpp"
#include "scene/physics/physics_state.hpp"

namespace plumb {

struct SoftLook;

/// Ropes, cloth and jellies are made where their components say. One whose component or place changes is made
/// anew.
/// @param all  an entity got or lost one
void followSoftBodies(World& world, PhysicsState& state, bool all);

/// Grows whenever some entity gets or loses a soft body.
[[nodiscard]] std::uint64_t softMembers(const World& world);

/// Whether there are any ropes, cloth or jellies.
[[nodiscard]] bool hasSoftBodies(const World& world);

/// The box around the soft bodies of an entity (px, world): where they lie, or will begin. Nothing when it
/// has none.
[[nodiscard]] std::optional<AABB> softBounds(const World& world, EntityId entity);

/// The component behind a soft body; nullptr when it is gone.
[[nodiscard]] const SoftLook* softLookOf(const World& world, const SoftLinkage& linkage);

}  // namespace plumb
