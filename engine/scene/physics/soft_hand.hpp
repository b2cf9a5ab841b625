#pragma once

#include <optional>

#include "ecs/world.hpp"
#include "scene/physics/physics_state.hpp"

namespace plumb {

/// A place on a rope, cloth or jelly.
struct SoftHit {
    EntityId entity;
    int particle = 0;  ///< the one that is nearest
    Vec2 place;        ///< px: where that is
};

/// What soft body lies at a place: the one with the nearest particle.
/// @param reach  px beside it that still count
/// @param mask   bits: the layers that it may have
std::optional<SoftHit> softBodyAt(World& world, Vec2 place, float reach, std::uint32_t mask = 0xffffffffu);

/// Where a SoftGrip holds its rope, cloth or jelly (px); nothing without one.
std::optional<Vec2> gripPlace(const World& world, EntityId entity);

/// Pulls what is held by a SoftGrip. @param dt  s
void pullSoftBodies(World& world, PhysicsState& state, float dt);

}  // namespace plumb
