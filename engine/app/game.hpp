#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "assets/asset_store.hpp"
#include "core/random.hpp"
#include "ecs/world.hpp"
#include "input/input.hpp"
#include "reflect/type_registry.hpp"
#include "scene/components/drawing/sprite.hpp"
#include "scene/drawing/background.hpp"
#include "scene/effects.hpp"
#include "scene/game_random.hpp"
#include "scene/physics/physics_threads.hpp"

namespace plumb {

class PrefabLibrary;

/// One running game: its world, its assets, its input. Derive from it to write a game in code; a game made
/// of scenes needs no class of its own (see SceneGame).
class Game {
public:
    Game();
    virtual ~Game();
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

    // For the game's own code. All of it is of the simulation: a replay repeats it.

    /// Its random numbers. Others, from rand() or a clock, make replays differ.
    [[nodiscard]] Random& random() { return world.resource<GameRandom>().random; }
    /// A sound that begins in this tick.
    /// @param volume  ratio
    void play(SoundId sound, float volume = 1.0f);
    /// The first entity of that Name, or the empty handle.
    [[nodiscard]] Entity find(std::string_view name);
    /// A new entity, and those below it, made of a prefab's file. What cannot be read is logged.
    /// @param place  px
    /// @return its root, or the empty handle
    Entity spawn(std::string_view prefab, Vec2 place);
    /// Where the mouse points, as the first enabled camera looks (px, world).
    [[nodiscard]] Vec2 mouseInWorld();
    /// A sprite of the whole picture, scaled to a size; Sprite(texture, width, height) shows a cell of it.
    /// @param width, height  px
    [[nodiscard]] Sprite wholePicture(TextureId texture, int width, int height);
    /// What is drawn behind everything, black at first. A scene's file has its own.
    void setBackground(Color color) { world.resource<Background>().color = color; }
    /// Puts a text in place of {word} in every Label, for texts that change. (The world keeps each text that
    /// was ever added to texts().)
    void show(std::string_view word, std::string_view text);

    const TypeRegistry types;
    World world;
    AssetStore assets;
    Input& input;            ///< lives in the world, so that a snapshot has it
    Effects effects;         ///< which of them run
    PhysicsThreads threads;  ///< of the physics, if there is work for them

private:
    std::unique_ptr<PrefabLibrary> spawned_;  ///< made when the first prefab is asked for
};

/// Advances the game by one tick of 1/60 s: input, onUpdate, the systems in order, then scene changes.
/// The same game and the same input give the same bits on every machine.
void tickGame(Game& game, const InputFrame& frame);

}  // namespace plumb
