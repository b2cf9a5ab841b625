#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "assets/asset_store.hpp"
#include "core/random.hpp"
#include "ecs/world.hpp"
#include "input/input.hpp"
#include "reflect/type_registry.hpp"
#include "scene/components/drawing/label.hpp"
#include "scene/components/drawing/sprite.hpp"
#include "scene/drawing/background.hpp"
#include "scene/effects.hpp"
#include "scene/game_random.hpp"
#include "scene/physics/physics_threads.hpp"

namespace plumb {

struct ContentChange;
class GameContent;
class PrefabLibrary;

/// A running game: its world, assets and input. Derive from it to write a game in code; a game made of scene
/// files needs no own class (see SceneGame).
class Game {
public:
    Game();
    /// @param content  component types, systems and effects; must outlive the game
    explicit Game(const GameContent& content);
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

    /// Called between ticks after changed files of the project were reloaded.
    virtual void onAssetsChanged([[maybe_unused]] std::span<const AssetChange> changes) {}

    /// Called between ticks after the state of the world was replaced by that of a saved game.
    virtual void onLoaded() {}

    /// True if the game ends after this tick: quitGame() was called.
    [[nodiscard]] virtual bool quitRequested() const;

    // For game code. All of these functions are part of the simulation and are repeated by replays.

    /// Random number generator of the simulation. Others, e.g. rand(), make replays diverge.
    [[nodiscard]] Random& random();
    /// Plays a sound, starting in this tick.
    /// @param volume  ratio, 0..1
    void play(SoundId sound, float volume = 1.0f);
    /// The same for a file, which is loaded at the first call.
    void play(std::string_view file, float volume = 1.0f) { play(assets.loadSound(file), volume); }
    /// Returns the first entity with this Name, or the empty handle.
    [[nodiscard]] Entity find(std::string_view name);
    /// Instantiates a prefab file: "coin", "prefabs/coin" or "prefabs/coin.prefab.json"; a file without
    /// folder may be in "prefabs" or in "assets". Errors are logged, each once.
    /// @param place  px, position of the root
    /// @return the root entity, or the empty handle
    Entity spawn(std::string_view prefab, Vec2 place);
    /// The same for a field of a component. @return the empty handle if the field is empty
    Entity spawn(PrefabId prefab, Vec2 place);
    /// Returns the first enabled camera. A game without one gets one that shows what was visible without it.
    Entity camera();
    /// Adds a Label that is fixed on the screen; for texts that change write {word} and call show().
    /// @param place  px, from the top-left corner of the screen
    /// @param size   px, height of a line
    Entity addText(std::string_view text, Vec2 place, float size = 8.0f, LabelAlign align = LabelAlign::Left);
    /// Returns the world position of the mouse (px) in the view of the first enabled camera.
    [[nodiscard]] Vec2 mouseInWorld();
    /// Returns a sprite that shows the whole texture, scaled to
    /// a size; Sprite(texture, width, height) shows one cell.
    /// @param width, height  px, size of the sprite
    [[nodiscard]] Sprite wholePicture(TextureId texture, int width, int height);
    /// Sets the background color of a game without scenes; black by default. Scene files define their own.
    void setBackground(Color color) { world.resource<Background>().color = color; }
    /// Sets the gravity of a game without scenes, px/s²; {0, 980} by default.
    void setGravity(Vec2 gravity);
    /// Sets the text that replaces {word} in every Label. Use it for changing texts, as the world keeps every
    /// text that was ever added to texts().
    void show(std::string_view word, std::string_view text);

    /// For the loop, between ticks: replaces the state of the world by that of a saved game (readSavedGame())
    /// and calls onLoaded().
    /// @error scripts cannot have their values again; the state is what it was before
    Result<Done> load(const Snapshot& saved);
    /// For the loop, after changed files were reloaded: reads changed prefabs again, for what is spawned from
    /// now on and for scenes that are loaded again, logs their problems, and calls onAssetsChanged().
    void followChanges(std::span<const AssetChange> changes);
    /// For the loop, after `content` was changed: converts the world, see convertWorld().
    void contentChanged(const ContentChange& change);
    /// For the loop: lets `assets` watch the files of all prefabs that were read, for followChanges().
    void watchPrefabs();
    /// For the loop: provides the prefabs of `assets` to spawn() in systems, which know only the world.
    void provideLibrary();

    const GameContent& content;
    const TypeRegistry& types;
    World world;
    AssetStore assets;
    Input& input;            ///< a world resource, so that snapshots include it
    Effects effects;         ///< decides which effects run
    PhysicsThreads threads;  ///< thread pool of the physics

private:
    std::unique_ptr<PrefabLibrary> spawned_;  ///< prefabs of spawn()
};

/// Advances the game by one tick of 1/60 s: input, onUpdate(), the systems in order, onLateUpdate(), which
/// also changes scenes. The same game with the same input is bit-identical on every machine.
void tickGame(Game& game, const InputFrame& frame);

}  // namespace plumb
