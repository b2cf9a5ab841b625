#include "app/game.hpp"

#include <string>
#include <utility>
#include <vector>

#include "app/game_content.hpp"
#include "app/step_clock.hpp"
#include "core/reports.hpp"
#include "gameplay/game_functions.hpp"
#include "gameplay/game_requests.hpp"
#include "scene/components/drawing/camera.hpp"
#include "scene/components/transform.hpp"
#include "scene/drawing/draw_scene.hpp"
#include "scene/files/prefab.hpp"
#include "scene/physics/physics_state.hpp"
#include "scene/scene_requests.hpp"
#include "scene/systems/camera_system.hpp"
#include "scene/world_transform.hpp"
#include "script/script_runner.hpp"
#include "script/script_state.hpp"

namespace plumb {

Game::Game() : Game{engineContent()} {}

Game::Game(const GameContent& gameContent)
    : content{gameContent},
      types{content.types()},
      world{types},
      input{world.resource<Input>()},
      effects{content.effects(), world} {
    world.provide(assets);
    world.provide(threads);
    world.provide(content.scripts());
    content.scripts().addTexts(world);
}

Game::~Game() = default;

bool Game::quitRequested() const {
    const auto* requests = world.findResource<SceneRequests>();
    return requests != nullptr && requests->quit;
}

Result<Done> Game::load(const Snapshot& saved) {
    const Snapshot before = world.save();
    world.restore(saved);
    const auto* scripts = world.findResource<ScriptState>();
    if (scripts != nullptr && !scripts->saved.empty() && !ScriptRunner{world}.tookSaved()) {
        world.restore(before);
        return Error{"saved game", "the values of its scripts are damaged or do not fit their memory",
                     "load another one"};
    }
    // Those of the tick in which it was saved have been performed.
    if (auto* requests = world.findResource<SceneRequests>()) *requests = {};
    onLoaded();
    return Done{};
}

void Game::setGravity(Vec2 gravity) { world.resource<PhysicsSettings>().gravity = gravity; }
Random& Game::random() { return randomOf(world); }
void Game::play(SoundId sound, float volume) { playSound(world, sound, volume); }
Entity Game::find(std::string_view name) { return findEntity(world, name); }
Vec2 Game::mouseInWorld() { return plumb::mouseInWorld(world); }
void Game::show(std::string_view word, std::string_view text) { showText(world, word, text); }

void Game::provideLibrary() {
    if (world.service<PrefabLibrary>() != nullptr) return;
    spawned_ = std::make_unique<PrefabLibrary>(types, assets.root());
    world.provide(*spawned_);
}

Entity Game::spawn(std::string_view prefab, Vec2 place) {
    provideLibrary();
    return plumb::spawn(world, prefab, place);
}

Entity Game::spawn(PrefabId prefab, Vec2 place) {
    provideLibrary();
    return plumb::spawn(world, prefab, place);
}

void Game::followChanges(std::span<const AssetChange> changes) {
    std::vector<std::string> paths;
    for (const AssetChange& change : changes) {
        if (change.kind == AssetKind::Prefab) paths.emplace_back(assets.pathOf(change.kind, change.path));
    }
    auto* prefabs = world.service<PrefabLibrary>();
    if (prefabs != nullptr && !paths.empty()) prefabs->readAgain(paths);
    onAssetsChanged(changes);
}

void Game::contentChanged(const ContentChange& change) {
    convertWorld(world, content, change);
    effects.tableChanged();
    if (auto* prefabs = world.service<PrefabLibrary>()) prefabs->forget();  // they name types
}

void Game::watchPrefabs() {
    const auto* prefabs = world.service<PrefabLibrary>();
    if (prefabs == nullptr) return;
    for (const Prefab& prefab : prefabs->known()) assets.load(AssetKind::Prefab, prefab.path);
}

Entity Game::camera() {
    for (auto [entity, camera, transform] : world.query<const Camera, const Transform>()) {
        if (camera.enabled) return entity;
    }
    const Entity made = world.createEntity();
    made.addComponent<Transform>(world.resource<PictureSize>().size / 2.0f);
    made.addComponent<Camera>();
    return made;
}

Entity Game::addText(std::string_view text, Vec2 place, float size, LabelAlign align) {
    const Entity made = world.createEntity();
    made.addComponent<Transform>(place);
    Label& label = made.addComponent<Label>();
    label.text = world.texts().add(text);
    label.size = size;
    label.align = align;
    label.screen = true;
    return made;
}

Sprite Game::wholePicture(TextureId texture, int width, int height) {
    Sprite sprite{texture, width, height};
    if (const Texture* picture = assets.find(texture))
        sprite.source = {0.0f, 0.0f, static_cast<float>(picture->width), static_cast<float>(picture->height)};
    return sprite;
}

void tickGame(Game& game, const InputFrame& frame) {
    constexpr auto kDt = static_cast<float>(StepClock::kStep);
    World& world = game.world;
    const Reporting reporting{world.reports()};
    game.provideLibrary();
    if (auto* requests = world.findResource<GameRequests>()) *requests = {};
    world.beginTick();
    storePreviousTransforms(world);
    game.effects.followScenes(world);
    game.input.advance(frame);
    game.onUpdate(kDt);
    world.update(kDt);
    game.onLateUpdate(kDt);
}

}  // namespace plumb
