#pragma once

#include <string_view>

namespace plumb {

class World;

/// Moves platforms along their paths. Positions are computed from the tick count, so they do not drift.
/// Reads: MovingPlatform. Writes: Transform of kinematic bodies.
/// When: before players and physics.
struct MovingPlatformSystem {
    static constexpr std::string_view kName = "moving platform";

    void update(World& world, float dt);
};

}  // namespace plumb
