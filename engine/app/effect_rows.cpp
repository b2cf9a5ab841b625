#include "app/effect_rows.hpp"

#include <algorithm>

#include "app/system_order.hpp"
#include "assets/asset_store.hpp"
#include "gameplay/components.hpp"
#include "gameplay/delayed_events.hpp"
#include "gameplay/tweens.hpp"
#include "scene/components.hpp"
#include "scene/drawing/tile_drawing.hpp"
#include "scene/lab.hpp"
#include "scene/loaded_scene.hpp"
#include "scene/particles.hpp"
#include "scene/play_sound.hpp"
#include "script/script_system.hpp"

namespace plumb {
namespace {

/// Returns an effect that runs while an entity has one of the components `Requesters`.
template <class... Requesters>
EffectRow row(std::string_view name, std::string_view doc, std::string_view device = {}) {
    EffectRow made{name, doc, kRequestersOf<Requesters...>,
                   isThereAny<typename RequesterOf<Requesters>::Component...>};
    made.device = device;
    return made;
}

bool hasDelayedEvents(const World& world) {
    const auto* delayed = world.findResource<DelayedEvents>();
    return delayed != nullptr && !delayed->entries.empty();
}
bool hasTweens(const World& world) {
    const auto* tweens = world.findResource<Tweens>();
    return tweens != nullptr && !tweens->entries.empty();
}

/// True if a component may play a sound, or code or a script has played one in this tick.
bool hasSound(const World& world) {
    return isThereAny<SoundCues, Music>(world) || !world.events<PlaySound>().empty();
}

/// True if there are emitters, or particles of destroyed emitters that must be removed.
bool hasParticles(const World& world) {
    if (isThereAny<ParticleEmitter>(world)) return true;
    const auto* left = world.findResource<Particles>();
    return left != nullptr && !left->streams.empty();
}

/// True if there are ghosts, or physics worlds of destroyed ghosts that must be removed.
bool hasGhosts(const World& world) {
    const auto* left = world.findResource<GhostWorlds>();
    return isThereAny<Ghost>(world) || (left != nullptr && !left->all.empty());
}
/// True if there are plots, or curves of destroyed plots that must be removed.
bool hasPlots(const World& world) {
    const auto* left = world.findResource<PlotPast>();
    return isThereAny<Plot>(world) || (left != nullptr && !left->curves.empty());
}

/// True if there is something to draw, even if only a background color.
bool hasPicture(const World& world) {
    if (isThereAny<Sprite, TileLayer, ParticleEmitter, Label, Rope, Cloth, Jelly, Slider, Plot, Ghost>(world))
        return true;
    const auto* loaded = world.findResource<LoadedScenes>();
    return loaded != nullptr && std::any_of(loaded->scenes.begin(), loaded->scenes.end(),
                                            [](const LoadedScene& scene) { return scene.background.a > 0; });
}

/// True if a tile layer has animated tiles. Not O(1), but not called in ticks.
bool hasAnimatedTiles(const World& world) {
    const auto* assets = world.service<AssetStore>();
    if (assets == nullptr || !isThereAny<TileLayer>(world)) return false;
    for (auto [entity, layer] : world.query<const TileLayer>(withPaused)) {
        if (isAnimated(assets->tileset(layer.tileset))) return true;
    }
    return false;
}

/// True if something may read gamepads.
bool readsPads(const World& world) {
    return hasScripts(world) || isThereAny<PlayerController, PushControl, SceneLink, Menu, SceneKey,
                                           ToggleKey, Detonator, Experiment>(world);
}

/// Returns all effects except those of the physics. To add one,
/// add a row here and name it at its systems in system_order.cpp.
std::vector<EffectRow> systemEffectRows() {
    std::vector<EffectRow> rows{
        {"timers", "Emits delayed events.", {}, hasDelayedEvents},
        row<PlayerController>("progress", "Counts time, coins and levels."),
        {"scripts", "Runs the Lua scripts of entities.", {}, hasScripts},
        row<MovingPlatform>("moving_platforms", "Moves platforms along their paths."),
        row<Patrol>("patrols", "Moves enemies back and forth."),
        row<PlayerController>("players", "Lets the player run, jump and pause."),
        row<CharacterController>("characters", "Moves characters at their velocity."),
        row<PushControl>("push_controls", "Lets the player accelerate bodies with the input axes."),
        row<MouseDrag>("mouse_drag", "Lets the mouse drag bodies."),
        row<Detonator>("detonators", "Triggers the explosions of detonators."),
        row<Slider>("sliders", "Lets sliders on the screen change numbers."),
        row<Experiment>("experiments", "Restores the initial state of experiments."),
        row<Ghost>("ghosts", "Simulates the physics of ghosts, with other settings."),
        row<Plot>("plots", "Records the curves of plots."),
        row<Label>("physics_counts", "Counts collision pairs for labels that show them."),
        row<Spring>("bouncers", "Lets springs launch bodies."),
        row<Portal>("portals", "Lets portals teleport bodies."),
        row<TouchColor>("touch_colors", "Tints sprites while they are in triggers."),
        row<Collectible>("collectibles", "Lets players pick up coins, keys and hearts."),
        row<Checkpoint>("checkpoints", "Activates checkpoints."),
        row<Goal, SceneLink>("goals", "Changes scenes at goals and scene links."),
        row<Menu>("menus", "Handles the input of menus."),
        row<Door, Button>("doors", "Opens doors with keys and buttons."),
        row<Hazard, KillPlane>("hazards", "Applies the damage of hazards, and lets players stomp enemies."),
        row<Health, Respawn>("respawn", "Respawns dead entities."),
        row<SceneKey, ToggleKey>("shortcuts", "Lets input actions change scenes, show and hide entities."),
        {"tweens", "Changes fields of components over time.", {}, hasTweens},
        row<Bob, Spin, Lifetime>("decor", "Runs the components Bob, Spin and Lifetime."),
        row<Animator, PlayerController>("character_animation",
                                        "Sets the animation parameters of characters."),
        row<Animator>("animation", "Plays sprite animations."),
        row<ParticleEmitter>("particles", "Emits and moves particles."),
        row<SoundCues, Music>("sound", "Plays sounds and music.", "audio device"),
        row<Camera>("camera", "Moves cameras to the entities they follow."),
        row<Sprite, TileLayer, ParticleEmitter, Label, Rope, Cloth, Jelly, Slider, Plot, Ghost>(
            "picture", "Draws the scene.", "renderer"),
        row<TileLayer>("tile_animation", "Animates tiles."),
        row<PlayerController, PushControl, SceneLink, Menu, SceneKey, ToggleKey, Detonator, Experiment>(
            "pads", "Reads gamepads.", "gamepads"),
    };
    for (EffectRow& made : rows) {
        if (made.name == "particles") made.isRequired = hasParticles;
        if (made.name == "sound") made.isRequired = hasSound;
        if (made.name == "ghosts") made.isRequired = hasGhosts;
        if (made.name == "plots") made.isRequired = hasPlots;
        if (made.name == "picture") made.isRequired = hasPicture;
        if (made.name == "tile_animation") made.isRequired = hasAnimatedTiles;
        if (made.name == "pads") made.isRequired = readsPads;
    }
    return rows;
}

EffectTable makeTable() {
    std::vector<EffectRow> rows = physicsEffectRows();
    for (const EffectRow& made : systemEffectRows()) rows.push_back(made);
    std::vector<EffectSystem> systems;
    for (const SystemRow& system : systemTable())
        systems.push_back({system.key(), system.name, system.effect});
    return {std::move(rows), std::move(systems)};
}

}  // namespace

const EffectTable& engineEffects() {
    static const EffectTable kTable = makeTable();
    return kTable;
}

}  // namespace plumb
