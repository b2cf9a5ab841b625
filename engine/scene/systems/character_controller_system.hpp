#pragma once

#include <string_view>

namespace plumb {

class World;

/// Moves characters through the solid world by their velocity.
/// Reads: colliders. Writes: Transform, CharacterController; adds CharacterBody; pushes rigid bodies.
/// When: after what steers characters and moves platforms, before physics.
struct CharacterControllerSystem {
    static constexpr std::string_view kName = "character";

    void update(World& world, float dt);
};

}  // namespace plumb
