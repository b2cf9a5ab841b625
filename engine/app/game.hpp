#pragma once

#include <span>

#include "assets/asset_store.hpp"
#include "ecs/world.hpp"
#include "input/input.hpp"
#include "reflect/type_registry.hpp"
#include "scene/effects.hpp"
#include "scene/physics_threads.hpp"

namespace plumb {

/// One running game: its world, its assets, its input. Derive from it to write a game in code; a game made
/// of scenes needs no class of its own (see SceneGame).
class Game {
public:
    Game();
    virtual ~Game() = default;
    Game(const Game&) = delete;
    Game& operator=(const Game&) = delete;

    /// Called once before the first tick: load assets, create entities, add systems.
    virtual void onCreate() {}

    /// Called every tick before the systems run.
    /// @param dt  s, always 1/60
    virtual void onUpdate([[maybe_unused]] float dt) {}

    /// Called every tick after the systems ran.
    virtual void onLateUpdate([[maybe_unused]] float dt) {}

    /// Called between ticks after files of the project were edited and read again.
    virtual void onAssetsChanged([[maybe_unused]] std::span<const AssetChange> changes) {}

    /// True when the game wants to end.
    [[nodiscard]] virtual bool quitRequested() const { return false; }

    const TypeRegistry types;
    World world;
    AssetStore assets;
    Input& input;            ///< lives in the world, so that a snapshot has it
    Effects effects;         ///< which of them run
    PhysicsThreads threads;  ///< of the physics, if there is work for them
};

/// Advances the game by one tick of 1/60 s: input, onUpdate, the systems in order, then scene changes.
/// The same game and the same input give the same bits on every machine.
void tickGame(Game& game, const InputFrame& frame);

}  // namespace plumb
