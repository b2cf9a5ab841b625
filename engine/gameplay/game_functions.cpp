#include "gameplay/game_functions.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "assets/asset_store.hpp"
#include "core/log.hpp"
#include "core/text.hpp"
#include "ecs/hierarchy.hpp"
#include "gameplay/components/triggers/lifetime.hpp"
#include "gameplay/game_requests.hpp"
#include "gameplay/label_values.hpp"
#include "input/input.hpp"
#include "scene/components/bodies/rigid_body.hpp"
#include "scene/components/drawing/animator.hpp"
#include "scene/components/drawing/camera.hpp"
#include "scene/components/name.hpp"
#include "scene/components/tags.hpp"
#include "scene/components/transform.hpp"
#include "scene/drawing/draw_scene.hpp"
#include "scene/files/prefab.hpp"
#include "scene/files/scene_path.hpp"
#include "scene/game_random.hpp"
#include "scene/play_sound.hpp"
#include "scene/scene_requests.hpp"
#include "scene/systems/camera_system.hpp"

namespace plumb {
namespace {

/// Returns the first child with this name, or the empty handle.
Entity findChild(World& world, Entity parent, std::string_view name) {
    if (!parent) return {};
    for (const Entity child : childrenOf(world, parent)) {
        const Name* named = std::as_const(world).find<Name>(child);
        if (named != nullptr && named->text == textId(name)) return child;
    }
    return {};
}

void requestScene(World& world, SceneId scene, bool overlay) {
    if (scene.empty()) return;
    SceneRequests& requests = world.resource<SceneRequests>();
    requests.next = scene.path;
    requests.overlay = overlay;
}

/// @param function  that was called, for errors
SceneId sceneNamed(World& world, std::string_view scene, std::string_view function) {
    if (scene.empty()) {
        logError("Scene", Error{format("{}(\"\")", function), "the name of the scene is empty",
                                "write that of a file in scenes/, e.g. \"level2\"; restartScene() loads the "
                                "current scene again"});
        return {};
    }
    return {world.texts().add(scenePath(scene))};
}

}  // namespace

Entity findEntity(World& world, std::string_view name) {
    const std::size_t slash = name.rfind('/');
    if (slash != std::string_view::npos)
        return findChild(world, findEntity(world, name.substr(0, slash)), name.substr(slash + 1));
    const TextId wanted = textId(name);
    EntityId first;
    for (auto [entity, named] : std::as_const(world).query<const Name>(withPaused)) {
        if (named.text == wanted && (!first || entity.id() < first)) first = entity.id();
    }
    return first ? world.entity(first) : Entity{};
}

std::vector<Entity> findEntities(World& world, std::string_view tag) {
    std::vector<Entity> found;
    for (auto [entity, tags] : std::as_const(world).query<const Tags>(withPaused)) {
        if (tags.has(tag)) found.push_back(world.entity(entity.id()));
    }
    std::sort(found.begin(), found.end());
    return found;
}

bool hasTag(const World& world, EntityId entity, std::string_view tag) {
    const Tags* tags = world.find<Tags>(entity);
    return tags != nullptr && tags->has(tag);
}

Entity spawn(World& world, std::string_view prefab, Vec2 position) {
    auto* library = world.service<PrefabLibrary>();
    PLUMB_ASSERT(library != nullptr && world.types() != nullptr, "spawn() needs the world of a Game");
    const Prefab* found = library->named(prefab);
    if (found == nullptr) return {};
    // Watched, so that it is read again after its file has changed.
    if (AssetStore& assets = assetsOf(world); !assets.root().empty())
        assets.load(AssetKind::Prefab, found->path);
    return spawnPrefab(world, *world.types(), *found, position);
}

Entity spawn(World& world, PrefabId prefab, Vec2 position) {
    return prefab.empty() ? Entity{} : spawn(world, world.texts().find(prefab.path), position);
}

Random& randomOf(World& world) { return world.resource<GameRandom>().random; }

void playSound(World& world, SoundId sound, float volume) {
    world.emit(PlaySound{sound, volume, {}, world.tick});
}

void playClip(World& world, EntityId entity, std::string_view clip) {
    auto* animator = world.find<Animator>(entity);
    if (animator == nullptr) return;
    const std::vector<Animation>& clips = assetsOf(world).animation(animator->animation).clips;
    const auto found =
        std::find_if(clips.begin(), clips.end(), [&](const Animation& other) { return other.name == clip; });
    const auto index = static_cast<int>(found - clips.begin());
    if (found == clips.end() || (animator->clip == index && animator->playing && !animator->ended)) return;
    animator->clip = index;
    animator->frame = animator->direction = 0;
    animator->timer = 0.0f;
    animator->ended = false;
    animator->playing = true;
}

void applyImpulse(World& world, EntityId entity, Vec2 impulse) {
    if (auto* body = world.find<RigidBody>(entity)) body->velocity += impulse / body->mass;
}

void shakeCamera(World& world, float strength, float seconds) {
    for (auto [entity, camera] : world.query<Camera>()) {
        if (camera.enabled) return shake(camera, strength, seconds);
    }
}

Entity burst(World& world, Vec2 position, int count, ParticleEmitter emitter) {
    constexpr float kTicks = 2.0f / 60.0f;  // s: the particles are born in the first tick; rounding
    emitter.playing = true;
    emitter.rate = 0.0f;
    emitter.burst = count;
    emitter.loop = emitter.prewarm = false;
    const Entity made = world.createEntity();
    made.addComponent<Transform>(position);
    made.addComponent<Lifetime>(emitter.lifetime * (1.0f + emitter.lifetimeSpread) + kTicks);
    made.addComponent<ParticleEmitter>(emitter);
    return made;
}

Vec2 mouseInWorld(World& world) {
    return toWorld(cameraView(world, world.resource<PictureSize>().size, 1.0f),
                   world.resource<Input>().mouse());
}

void showText(World& world, std::string_view word, std::string_view text) {
    world.resource<LabelValues>().set(word, text);
}

AssetStore& assetsOf(World& world) {
    auto* assets = world.service<AssetStore>();
    PLUMB_ASSERT(assets != nullptr, "assetsOf() needs the world of a Game");
    return *assets;
}

void changeScene(World& world, SceneId scene) { requestScene(world, scene, false); }
void changeScene(World& world, std::string_view scene) {
    changeScene(world, sceneNamed(world, scene, "changeScene"));
}
void showOverlay(World& world, SceneId scene) { requestScene(world, scene, true); }
void showOverlay(World& world, std::string_view scene) {
    showOverlay(world, sceneNamed(world, scene, "showOverlay"));
}
void hideOverlay(World& world) { world.resource<SceneRequests>().close = true; }
void restartScene(World& world) { world.resource<SceneRequests>().reload = true; }
void quitGame(World& world) { world.resource<SceneRequests>().quit = true; }

namespace {

/// True for the number of a slot; else it is logged.
bool isSlot(const World& world, int slot, std::string_view call) {
    if (slot >= 1 && slot <= kSaveSlots) return true;
    const std::string where = format("{}({})", call, slot);
    if (world.reports().isFirst("Game", where))
        logError("Game",
                 Error{where, format("saved games have the slots 1 to {}", kSaveSlots), "use one of these"});
    return false;
}

}  // namespace

void saveGame(World& world, int slot) {
    if (isSlot(world, slot, "saveGame")) world.resource<GameRequests>().save = slot;
}
void loadGame(World& world, int slot) {
    if (isSlot(world, slot, "loadGame")) world.resource<GameRequests>().load = slot;
}
bool hasSave(const World& world, int slot) {
    const auto* input = world.findResource<Input>();
    return input != nullptr && slot >= 1 && slot <= kSaveSlots &&
           (input->frame().saves >> (slot - 1) & 1) != 0;
}
void showOptions(World& world) { world.resource<GameRequests>().options = true; }

}  // namespace plumb
