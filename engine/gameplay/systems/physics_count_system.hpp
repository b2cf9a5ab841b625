#pragma once

#include <string_view>

namespace plumb {

class World;

/// Stores the counters of collision detection for labels that show them.
/// Reads: PhysicsState. Writes: PhysicsCounts.
/// When: after physics.
struct PhysicsCountSystem {
    static constexpr std::string_view kName = "physics counts";

    void update(World& world, float dt);
};

}  // namespace plumb
