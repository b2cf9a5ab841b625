#pragma once

#include <string_view>

namespace plumb {

class World;

/// Makes the physics step compute contacts and triggers. The step runs once per tick: in the last system of
/// GravitySystem, MovementSystem and CollisionSystem that the world has.
struct CollisionSystem {
    static constexpr std::string_view kName = "collision";

    void update(World& world, float dt);
};

}  // namespace plumb
