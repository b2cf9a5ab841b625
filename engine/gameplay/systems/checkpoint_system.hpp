#pragma once

#include <string_view>

namespace plumb {

class World;

/// Activates checkpoints that a player touches and sets its respawn position.
/// Reads: TriggerEntered. Writes: Checkpoint, Respawn, Animator; emits PlaySound.
/// When: after physics.
struct CheckpointSystem {
    static constexpr std::string_view kName = "checkpoint";

    void update(World& world, float dt);
};

}  // namespace plumb
