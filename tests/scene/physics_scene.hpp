#pragma once

#include "scene/components.hpp"
#include "scene/physics/physics_state.hpp"
#include "scene/physics_bridge.hpp"
#include "scene/systems/character_controller_system.hpp"
#include "scene/systems/physics_system.hpp"

namespace plumb {

/// A world with physics and helpers to fill it.
struct PhysicsScene {
    static constexpr float kTick = 1.0f / 60.0f;  ///< s

    World world;

    PhysicsScene() {
        world.addSystem<CharacterControllerSystem>();
        world.addSystem<PhysicsSystem>();
        constexpr std::string_view kOrder[] = {"character", "physics"};
        world.setSystemOrder(kOrder);
    }

    void run(int ticks) {
        for (int i = 0; i < ticks; ++i) {
            world.beginTick();
            world.update(kTick);
        }
    }
    Entity at(Vec2 place) {
        Entity entity = world.createEntity();
        entity.addComponent<Transform>(place.x, place.y);
        return entity;
    }
    Entity ball(Vec2 place, float radius = 8.0f) {
        Entity entity = at(place);
        entity.addComponent<RigidBody>();
        entity.addComponent<CircleCollider>(radius);
        return entity;
    }
    /// @param place  position of its upper left corner
    Entity crate(Vec2 place, float size = 16.0f) {
        Entity entity = at(place);
        entity.addComponent<RigidBody>();
        entity.addComponent<BoxCollider>(size, size);
        return entity;
    }
    Entity floor(Vec2 corner, Vec2 size) {
        Entity entity = at(corner);
        entity.addComponent<BoxCollider>(size.x, size.y);
        return entity;
    }
    PhysicsState& state() { return world.resource<PhysicsState>(); }
    static Vec2 place(Entity entity) { return entity.get<Transform>().position; }
};

}  // namespace plumb
