#pragma once

#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "assets/asset_store.hpp"
#include "ecs/world.hpp"
#include "gameplay/components.hpp"
#include "gameplay/game_progress.hpp"
#include "gameplay/systems.hpp"
#include "input/input.hpp"
#include "scene/components/bodies/kinematic_body.hpp"
#include "scene/components/bodies/rigid_body.hpp"
#include "scene/components/bodies/static_body.hpp"
#include "scene/components/colliders/box_collider.hpp"
#include "scene/components/colliders/tile_collider.hpp"
#include "scene/components/drawing/tile_layer.hpp"
#include "scene/components/transform.hpp"
#include "scene/systems/physics_system.hpp"
#include "scene/world_transform.hpp"

namespace plumb {

/// A level built from rows of characters, each a tile of 16 px, with a player:
/// # full, - one-way, / and \ slopes of 45 degrees, l h and H L slopes of half that gradient.
struct Level {
    static constexpr float kTick = 1.0f / 60.0f;  // s

    AssetStore assets;
    World world;
    InputFrame frame;
    Entity player;

    explicit Level(const std::vector<std::string_view>& rows) {
        world.provide(assets);
        world.addSystem<ProgressSystem>();
        world.addSystem<MovingPlatformSystem>();
        world.addSystem<PatrolSystem>();
        world.addSystem<PlayerControllerSystem>();
        world.addSystem<PhysicsSystem>();
        world.addSystem<SpringSystem>();
        world.addSystem<HazardSystem>();
        world.addSystem<CollectSystem>();
        world.addSystem<CheckpointSystem>();
        world.addSystem<GoalSystem>();
        world.addSystem<DoorSystem>();
        world.addSystem<RespawnSystem>();
        world.addSystem<CharacterAnimationSystem>();
        world.addSystem<MotionDecorSystem>();
        makeTiles(rows);
    }

    /// Adds a player of 12 x 20 px whose feet are at this position.
    Entity addPlayer(Vec2 feet) {
        player = world.createEntity();
        player.addComponent<Transform>(feet.x - 6.0f, feet.y - 20.0f);
        player.addComponent<RigidBody>();
        player.addComponent<BoxCollider>(12, 20);
        player.addComponent<PlayerController>();
        player.addComponent<Health>();
        player.addComponent<Respawn>();
        return player;
    }
    Entity addBox(Vec2 corner, Vec2 size, bool trigger = false) {
        Entity entity = world.createEntity();
        entity.addComponent<Transform>(corner.x, corner.y);
        entity.addComponent<BoxCollider>(size.x, size.y).isTrigger = trigger;
        return entity;
    }

    void tick() {
        world.beginTick();
        storePreviousTransforms(world);
        world.resource<Input>().advance(frame);
        world.update(kTick);
    }
    void run(int ticks) {
        for (int i = 0; i < ticks; ++i) tick();
    }
    void hold(Key key, bool held = true) { frame.set(key, held); }
    /// Runs until the player rests on the ground.
    void settle() { run(30); }

    [[nodiscard]] Vec2 at() { return player.get<Transform>().position; }
    [[nodiscard]] float feet() { return at().y + 20.0f; }
    [[nodiscard]] Vec2 velocity() { return player.get<RigidBody>().velocity; }
    [[nodiscard]] bool grounded() { return player.get<RigidBody>().grounded; }

    template <class E>
    [[nodiscard]] int count() {
        return static_cast<int>(world.events<E>().size());
    }

private:
    void makeTiles(const std::vector<std::string_view>& rows) {
        constexpr std::string_view kLetters = "#-/\\lhHL";
        constexpr TileShape kShapes[] = {
            TileShape::Full,       TileShape::OneWay,      TileShape::SlopeUp,       TileShape::SlopeDown,
            TileShape::SlopeUpLow, TileShape::SlopeUpHigh, TileShape::SlopeDownHigh, TileShape::SlopeDownLow};
        if (rows.empty()) return;
        Tileset tileset;
        tileset.count = 8;
        for (int i = 0; i < 8; ++i) {
            Tile tile;
            tile.id = i;
            tile.shape = kShapes[i];
            tileset.tiles.push_back(tile);
        }
        TileGrid grid{static_cast<int>(rows[0].size()), static_cast<int>(rows.size())};
        for (int y = 0; y < grid.height(); ++y) {
            for (int x = 0; x < grid.width(); ++x) {
                const auto row = rows[static_cast<std::size_t>(y)];
                const std::size_t letter = kLetters.find(row[static_cast<std::size_t>(x)]);
                if (letter != std::string_view::npos) grid.set(x, y, cellOf(static_cast<int>(letter)));
            }
        }
        Entity level = world.createEntity();
        level.addComponent<Transform>(0.0f, 0.0f);
        TileLayer& layer = level.addComponent<TileLayer>();
        layer.tileset = assets.addTileset("test", tileset);
        layer.cells = world.tiles().add(grid);
        level.addComponent<TileCollider>();
    }
};

}  // namespace plumb
