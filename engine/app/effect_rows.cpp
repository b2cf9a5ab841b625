#include "app/effect_rows.hpp"

#include <algorithm>

#include "app/system_order.hpp"
#include "assets/asset_store.hpp"
#include "gameplay/components.hpp"
#include "scene/components.hpp"
#include "scene/drawing/tile_drawing.hpp"
#include "scene/lab.hpp"
#include "scene/loaded_scene.hpp"
#include "scene/particles.hpp"

namespace plumb {
namespace {

/// An effect that systems run for as long as there is any of these components.
template <class... Callers>
EffectRow row(std::string_view name, std::string_view doc, std::string_view device = {}) {
    EffectRow made{name, doc, kCallersOf<Callers...>, isThereAny<typename CallerOf<Callers>::Component...>};
    made.device = device;
    return made;
}

/// What the last emitters left has to go.
bool hasParticles(const World& world) {
    if (isThereAny<ParticleEmitter>(world)) return true;
    const auto* left = world.findResource<Particles>();
    return left != nullptr && !left->streams.empty();
}

/// And what the last ghosts and plots left.
bool hasGhosts(const World& world) {
    const auto* left = world.findResource<GhostWorlds>();
    return isThereAny<Ghost>(world) || (left != nullptr && !left->all.empty());
}
bool hasPlots(const World& world) {
    const auto* left = world.findResource<PlotPast>();
    return isThereAny<Plot>(world) || (left != nullptr && !left->curves.empty());
}

/// A scene may be nothing but its color.
bool hasPicture(const World& world) {
    if (isThereAny<Sprite, TileLayer, ParticleEmitter, Label, Rope, Cloth, Jelly, Slider, Plot, Ghost>(world))
        return true;
    const auto* loaded = world.findResource<LoadedScenes>();
    return loaded != nullptr && std::any_of(loaded->scenes.begin(), loaded->scenes.end(),
                                            [](const LoadedScene& scene) { return scene.background.a > 0; });
}

/// Not asked in a tick, only where tiles are drawn.
bool hasAnimatedTiles(const World& world) {
    const auto* assets = world.service<AssetStore>();
    if (assets == nullptr || !isThereAny<TileLayer>(world)) return false;
    for (auto [entity, layer] : world.query<const TileLayer>(withPaused)) {
        if (isAnimated(assets->tileset(layer.tileset))) return true;
    }
    return false;
}

/// Every effect beside those of the physics. A row is all that a new one needs; its systems name it in
/// system_order.cpp.
std::vector<EffectRow> systemEffectRows() {
    std::vector<EffectRow> rows{
        row<PlayerController>("progress", "Time, coins and levels are counted."),
        row<MovingPlatform>("moving_platforms", "Platforms go their ways."),
        row<Patrol>("patrols", "Enemies walk to and fro."),
        row<PlayerController>("players", "The player runs, jumps and pauses."),
        row<CharacterController>("characters", "Characters walk by their velocity."),
        row<PushControl>("push_controls", "The player pushes bodies."),
        row<MouseDrag>("mouse_drag", "The mouse drags bodies."),
        row<Detonator>("detonators", "Bombs go off."),
        row<Slider>("sliders", "Sliders on the screen change numbers."),
        row<Experiment>("experiments", "Experiments begin anew."),
        row<Ghost>("ghosts", "The physics runs again with other settings."),
        row<Plot>("plots", "Curves are drawn of the physics."),
        row<Label>("physics_counts", "Labels show numbers of the physics."),
        row<Spring>("bouncers", "Springs throw up what lands on them."),
        row<Portal>("portals", "Portals lead elsewhere."),
        row<TouchColor>("touch_colors", "What is touched changes its color."),
        row<Collectible>("collectibles", "Coins, keys and hearts are picked up."),
        row<Checkpoint>("checkpoints", "Checkpoints are remembered."),
        row<Goal, SceneLink>("goals", "Goals and links lead to other scenes."),
        row<Menu>("menus", "Menus are chosen from."),
        row<Door, Button>("doors", "Keys and buttons open doors."),
        row<Hazard, KillPlane>("hazards", "Hazards hurt, enemies are stomped."),
        row<Health, Respawn>("respawn", "The dead come back."),
        row<SceneKey, ToggleKey>("shortcuts", "Keys lead to scenes, show and hide."),
        row<Bob, Spin, Lifetime>("decor", "Things bob, spin and end."),
        row<Animator, PlayerController>("character_animation", "Animations follow how characters move."),
        row<Animator>("animation", "Pictures change by themselves."),
        row<ParticleEmitter>("particles", "Emitters send particles."),
        row<SoundCues, Music>("sound", "Sounds and music are played.", "audio device"),
        row<Camera>("camera", "The view follows what it shall."),
        row<Sprite, TileLayer, ParticleEmitter, Label, Rope, Cloth, Jelly, Slider, Plot, Ghost>(
            "picture", "The scene is drawn.", "renderer"),
        row<TileLayer>("tile_animation", "Animated tiles move."),
        row<PlayerController, PushControl, SceneLink, Menu, SceneKey, ToggleKey, Detonator, Experiment>(
            "pads", "Gamepads are heard.", "gamepads"),
    };
    for (EffectRow& made : rows) {
        if (made.name == "particles") made.calledFor = hasParticles;
        if (made.name == "ghosts") made.calledFor = hasGhosts;
        if (made.name == "plots") made.calledFor = hasPlots;
        if (made.name == "picture") made.calledFor = hasPicture;
        if (made.name == "tile_animation") made.calledFor = hasAnimatedTiles;
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
