#pragma once

#include <optional>

#include "ecs/world.hpp"
#include "scene/physics/physics_state.hpp"

namespace plumb {

/// A point on a rope, cloth or jelly.
struct SoftHit {
    EntityId entity;
    int particle = 0;  ///< index of the nearest particle
    Vec2 place;        ///< px, position of that particle
};

/// Returns the soft body at a position (px); if there are several, the one with the nearest particle.
/// @param reach  px, maximum distance from the soft body
/// @param mask   bits: layers of the soft bodies to consider
std::optional<SoftHit> softBodyAt(World& world, Vec2 place, float reach, std::uint32_t mask = 0xffffffffu);

/// Returns the point at which a SoftGrip holds its rope, cloth or jelly (px); nullopt without a SoftGrip.
std::optional<Vec2> gripPlace(const World& world, EntityId entity);

/// Applies the pull of every SoftGrip to its soft body. @param dt  s, length of the tick
void pullSoftBodies(World& world, PhysicsState& state, float dt);

}  // namespace plumb
