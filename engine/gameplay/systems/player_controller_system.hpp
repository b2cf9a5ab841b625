#pragma once

#include <string_view>

namespace plumb {

class World;

/// Moves every PlayerController by the player's input, with collisions.
/// Reads: Input, colliders. Writes: Transform, RigidBody, PlayerController; adds CharacterBody; emits
/// PlaySound. When: after platforms and patrols, before physics.
struct PlayerControllerSystem {
    static constexpr std::string_view kName = "player controller";

    void update(World& world, float dt);
};

}  // namespace plumb
