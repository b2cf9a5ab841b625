#pragma once

#include <string_view>

namespace plumb {

class World;

/// Brings the dead back, and lets the hurt blink.
/// Reads: Health. Writes: Respawn, Transform, RigidBody, Sprite, GameProgress.
/// When: after hazards.
struct RespawnSystem {
    static constexpr std::string_view kName = "respawn";

    void update(World& world, float dt);
};

}  // namespace plumb
