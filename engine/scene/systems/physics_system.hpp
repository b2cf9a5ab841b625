#pragma once

#include <string_view>

#include "ecs/world.hpp"
#include "scene/physics_bridge.hpp"
#include "scene/systems/collision_system.hpp"
#include "scene/systems/gravity_system.hpp"
#include "scene/systems/movement_system.hpp"

namespace plumb {

/// Runs physics with the effects that the world calls for. A world with GravitySystem, MovementSystem or
/// CollisionSystem gets those effects; one with this system alone gets what its components call for.
/// Reads/writes: see stepPhysics. When: after controllers, before whatever answers to contacts.
struct PhysicsSystem {
    static constexpr std::string_view kName = "physics";

    void update(World& world, float dt) { stepPhysics(world, dt); }
};

/// The three systems that call for effects stand for one step: the last of those present runs it.
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
