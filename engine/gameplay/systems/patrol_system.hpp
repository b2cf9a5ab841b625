#pragma once

#include <string_view>

namespace plumb {

class World;

/// Moves the entities with a Patrol component.
/// Reads: colliders. Writes: Patrol, velocity of KinematicBody or RigidBody, Sprite.flipX.
/// When: before physics.
struct PatrolSystem {
    static constexpr std::string_view kName = "patrol";

    void update(World& world, float dt);
};

}  // namespace plumb
