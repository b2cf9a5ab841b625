#include "scene/scene_stack.hpp"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "core/text.hpp"
#include "ecs/hierarchy.hpp"
#include "ecs/paused.hpp"
#include "input/input.hpp"
#include "scene/components/drawing/overlay.hpp"
#include "scene/components/persistent.hpp"
#include "scene/components/scene_entity.hpp"
#include "scene/loaded_scene.hpp"
#include "scene/physics/physics_state.hpp"

namespace plumb {
namespace {

std::vector<SceneId> loadedIds(const World& world) {
    std::vector<SceneId> ids;
    if (const LoadedScenes* loaded = world.findResource<LoadedScenes>()) {
        for (const LoadedScene& scene : loaded->scenes) ids.push_back(scene.id);
    }
    return ids;
}

/// Destroys those entities of `made` that belong to no scene file,
/// except persistent ones and their children.
void destroyMade(World& world, const std::vector<EntityId>& made) {
    for (const EntityId id : made) {
        if (world.alive(id) && !std::as_const(world).has<SceneEntity>(id) && !persists(world, id))
            world.destroy(id);
    }
}

void resume(World& world, std::uint32_t by) {
    std::vector<EntityId> paused;
    for (auto [entity, pause] : std::as_const(world).query<const Paused>()) {
        if (pause.by >= by) paused.push_back(entity.id());
    }
    // Remove from last to first, so that no component is moved in its pool.
    for (auto id = paused.rbegin(); id != paused.rend(); ++id) world.remove<Paused>(*id);
}

/// Restores the physics that was paused by the lowest overlay whose index in the stack is at least `from`.
void restorePhysics(World& world, const LoadedScenes& loaded, std::size_t from) {
    for (std::size_t i = from; i < loaded.scenes.size(); ++i) {
        if (loaded.scenes[i].below == nullptr) continue;
        world.resource<PhysicsState>() = *loaded.scenes[i].below;
        return;
    }
}

Overlay modeOf(const World& world, SceneId scene) {
    for (auto [entity, overlay, source] : world.query<const Overlay, const SceneEntity>(withPaused)) {
        if (source.scene == scene) return overlay;
    }
    return {};
}

void pause(World& world, const std::vector<EntityId>& below, LoadedScene& overlay, std::uint32_t place) {
    for (const EntityId id : below) {
        if (!std::as_const(world).has<Paused>(id)) world.add<Paused>(id, Paused{place});
    }
    PhysicsState& physics = world.resource<PhysicsState>();
    overlay.below = std::make_shared<const PhysicsState>(std::move(physics));
    physics = {};
}

Result<LoadReport> loadText(World& world, const SceneContext& context, std::string_view path,
                            const std::string& text) {
    Result<LoadReport> report = loadScene(world, context, path, text);
    AssetStore* assets = world.service<AssetStore>();
    if (report.ok() && assets != nullptr) loadAssets(world, context.types, *assets);
    return report;
}

}  // namespace

Result<LoadReport> switchScene(World& world, const SceneContext& context, std::string_view path,
                               const std::string* text) {
    // Load the new scene first: if it cannot be read, the old ones are kept.
    const std::vector<SceneId> before = loadedIds(world);
    const std::vector<EntityId> entities = world.entities();
    const auto leave = [&] {
        if (LoadedScenes* loaded = world.findResource<LoadedScenes>()) restorePhysics(world, *loaded, 0);
        resume(world, 0);
        for (const SceneId scene : before) unloadScene(world, scene);
        destroyMade(world, entities);
        world.dropWaitingEvents();
    };
    const bool again = std::find(before.begin(), before.end(), sceneId(path)) != before.end();
    if (again) leave();
    Result<LoadReport> report =
        text != nullptr ? loadText(world, context, path, *text) : loadSceneFile(world, context, path);
    if (report.ok() && !again) leave();
    if (report.ok()) world.reports().forget();
    return report;
}

Result<LoadReport> openOverlay(World& world, const SceneContext& context, std::string_view path) {
    const std::vector<SceneId> before = loadedIds(world);
    if (std::find(before.begin(), before.end(), sceneId(path)) != before.end()) {
        return Error{std::string{path}, "the scene is already open", "close it before opening it again"};
    }
    const std::vector<EntityId> below = world.entities();
    Result<LoadReport> report = loadSceneFile(world, context, path);
    if (!report) return report;
    const Overlay mode = modeOf(world, report->scene);
    LoadedScene& scene = world.resource<LoadedScenes>().scenes.back();
    scene.pauses = mode.pauses;
    scene.takesInput = mode.takesInput;
    if (mode.pauses) pause(world, below, scene, static_cast<std::uint32_t>(before.size()));
    return report;
}

bool closeOverlay(World& world) {
    LoadedScenes* loaded = world.findResource<LoadedScenes>();
    if (loaded == nullptr || loaded->scenes.size() < 2) return false;
    const LoadedScene top = loaded->scenes.back();
    const auto place = static_cast<std::uint32_t>(loaded->scenes.size() - 1);
    if (top.pauses) {
        std::vector<EntityId> made = world.entities();
        std::erase_if(made, [&](EntityId id) { return std::as_const(world).has<Paused>(id); });
        destroyMade(world, made);
    }
    restorePhysics(world, *loaded, place);
    unloadOverlay(world, top.id);
    resume(world, place);
    loaded->resumedAt = world.tick;
    return true;
}

std::size_t placeOf(const World& world, EntityId entity) {
    const LoadedScenes* loaded = world.findResource<LoadedScenes>();
    if (loaded == nullptr || loaded->scenes.size() < 2) return 0;
    const std::vector<LoadedScene>& scenes = loaded->scenes;
    if (const auto* source = world.find<SceneEntity>(entity)) {
        for (std::size_t i = 0; i < scenes.size(); ++i) {
            if (scenes[i].id == source->scene) return i;
        }
    }
    std::size_t place = scenes.size();
    if (const auto* paused = world.find<Paused>(entity)) place = std::min<std::size_t>(paused->by, place);
    // Entities without a scene belong to the top scene that was not paused when they were created.
    for (std::size_t i = place; i-- > 1;) {
        if (scenes[i].pauses) return i;
    }
    return 0;
}

std::uint32_t loadingOf(const World& world, EntityId entity) {
    const LoadedScenes* loaded = world.findResource<LoadedScenes>();
    if (loaded == nullptr || loaded->scenes.empty() || persists(world, entity)) return 0;
    return loaded->scenes[placeOf(world, entity)].loading;
}

const PhysicsState* lowestPhysics(const World& world) {
    if (const LoadedScenes* loaded = world.findResource<LoadedScenes>()) {
        for (const LoadedScene& scene : loaded->scenes) {
            if (scene.below != nullptr) return scene.below.get();
        }
    }
    return world.findResource<PhysicsState>();
}

const Input& inputFor(World& world, EntityId entity) {
    static const Input kSilence{ActionMap{}};
    const Input& input = world.resource<Input>();
    const LoadedScenes* loaded = world.findResource<LoadedScenes>();
    if (loaded == nullptr || loaded->scenes.size() < 2) return input;
    for (std::size_t i = placeOf(world, entity) + 1; i < loaded->scenes.size(); ++i) {
        if (loaded->scenes[i].takesInput) return kSilence;
    }
    return input;
}

}  // namespace plumb
