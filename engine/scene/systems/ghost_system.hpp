#pragma once

#include <string_view>

namespace plumb {

class World;

/// Steps the physics worlds of all ghosts.
/// Reads: PhysicsState, Ghost, Lab. Writes: GhostWorlds.
/// When: right after physics.
struct GhostSystem {
    static constexpr std::string_view kName = "ghosts";

    void update(World& world, float dt);  ///< dt in s
};

}  // namespace plumb
