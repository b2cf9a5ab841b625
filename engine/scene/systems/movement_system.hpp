#pragma once

#include <string_view>

namespace plumb {

class World;

/// Makes bodies move at their velocity in the physics step. The step runs once per tick: in the last system
/// of GravitySystem, MovementSystem and CollisionSystem that the world has.
struct MovementSystem {
    static constexpr std::string_view kName = "movement";

    void update(World& world, float dt);
};

}  // namespace plumb
