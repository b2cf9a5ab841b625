#pragma once

#include <string_view>

namespace plumb {

class World;

/// Moves the entities with a CharacterController at their velocity, with collisions.
/// Reads: colliders. Writes: Transform, CharacterController; adds CharacterBody; pushes rigid bodies.
/// When: after the systems that control characters and move platforms, before physics.
struct CharacterControllerSystem {
    static constexpr std::string_view kName = "character";

    void update(World& world, float dt);
};

}  // namespace plumb
