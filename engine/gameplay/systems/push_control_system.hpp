#pragma once

#include <string_view>

namespace plumb {

class World;

/// Applies the player's input to bodies with a PushControl.
/// Reads: Input, PushControl. Writes: RigidBody. Emits: PlaySound.
/// When: before physics.
struct PushControlSystem {
    static constexpr std::string_view kName = "push control";

    void update(World& world, float dt);
};

}  // namespace plumb
