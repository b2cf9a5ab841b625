#pragma once

#include <string_view>

namespace plumb {

class World;

/// Makes gravity act on rigid bodies in the physics step. The step runs once per tick: in the last system of
/// GravitySystem, MovementSystem and CollisionSystem that the world has.
struct GravitySystem {
    static constexpr std::string_view kName = "gravity";

    void update(World& world, float dt);
};

}  // namespace plumb
