#pragma once

#include <string_view>

#include "ecs/world.hpp"
#include "scene/physics_bridge.hpp"
#include "scene/systems/collision_system.hpp"
#include "scene/systems/gravity_system.hpp"
#include "scene/systems/movement_system.hpp"

namespace plumb {

/// Runs the physics step. In a world that has GravitySystem, MovementSystem or CollisionSystem, it computes
/// only what these request; with this system alone, everything that components request. Reads and writes: see
/// stepPhysics(). When: after controllers, before systems that react to contacts.
struct PhysicsSystem {
    static constexpr std::string_view kName = "physics";

    void update(World& world, float dt) { stepPhysics(world, dt); }
};

/// Called by the three systems that request effects: runs the step if `System` is the last of those present.
template <class System>
void stepAsLast(World& world, float dt) {
    if (world.hasSystem<PhysicsSystem>()) return;
    constexpr int kRank = std::is_same_v<System, GravitySystem>    ? 0
                          : std::is_same_v<System, MovementSystem> ? 1
                                                                   : 2;
    if (kRank < 1 && world.hasSystem<MovementSystem>()) return;
    if (kRank < 2 && world.hasSystem<CollisionSystem>()) return;
    stepPhysics(world, dt);
}

}  // namespace plumb
