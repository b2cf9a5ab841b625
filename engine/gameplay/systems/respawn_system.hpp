#pragma once

#include <string_view>

namespace plumb {

class World;

/// Respawns dead entities, and makes invulnerable ones blink.
/// Reads: Health. Writes: Respawn, Transform, RigidBody, Sprite, GameProgress.
/// When: after hazards.
struct RespawnSystem {
    static constexpr std::string_view kName = "respawn";

    void update(World& world, float dt);
};

}  // namespace plumb
