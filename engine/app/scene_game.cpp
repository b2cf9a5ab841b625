#include "app/scene_game.hpp"

#include <algorithm>
#include <utility>

#include "core/log.hpp"
#include "gameplay/pause_scene.hpp"
#include "gameplay/systems/progress_system.hpp"
#include "platform/paths.hpp"
#include "reflect/json.hpp"
#include "reflect/json_text.hpp"
#include "scene/files/scene_path.hpp"
#include "scene/game_random.hpp"
#include "scene/loaded_scene.hpp"
#include "scene/physics/physics_state.hpp"
#include "scene/scene_requests.hpp"
#include "scene/scene_stack.hpp"
#include "scene/systems/camera_system.hpp"
#include "scene/world_transform.hpp"

namespace plumb {
namespace {

/// Ticks for which unreferenced assets stay loaded after a scene change: sounds of the old scene may still be
/// playing, and returning to it soon is fast.
constexpr int kUnloadTicks = 60;

}  // namespace

SceneGame::SceneGame(Project project, std::string firstScene, std::uint64_t seed,
                     const GameContent& gameContent)
    : Game{gameContent},
      project_{std::move(project)},
      firstScene_{firstScene.empty() ? project_.startScene : scenePath(firstScene)},
      prefabs_{types, project_.root} {
    assets = AssetStore{project_.root, engineAssets()};
    input.setMap(project_.actions);
    world.resource<GameRandom>().random = Random::seeded(seed);
    world.resource<PhysicsSettings>().gravity = project_.gravity;
    world.resource<PhysicsSettings>().pixelsPerMetre = project_.pixelsPerMetre;
    world.resource<PhysicsSettings>().tolerances.quality = qualityOf(project_.physicsQuality);
    world.resource<PictureSize>().size = {static_cast<float>(project_.width),
                                          static_cast<float>(project_.height)};
    world.resource<PauseScene>().path = {world.texts().add(project_.pauseScene)};
    world.provide(prefabs_);
    content.addSystems(world);
}

void SceneGame::onCreate() {
    if (firstScene_.empty()) {
        failure_ = Error{"project.json", "\"startScene\" is missing",
                         "write \"startScene\": \"scenes/title.scene.json\""};
    } else if (const auto opened = openScene(firstScene_); !opened) {
        failure_ = opened.error();
    }
    quit_ = failure_.has_value();
}

Result<Done> SceneGame::openScene(std::string_view path) {
    const bool isReplaced = !replacedPath_.empty() && path == replacedPath_;
    const Result<LoadReport> report =
        switchScene(world, context(), path, isReplaced ? &replacementText_ : nullptr);
    if (!report) return report.error();
    if (!isReplaced) logProblems(*report);
    beginLevel(world);
    heldScenes_.clear();
    followAssets();
    storePreviousTransforms(world);
    world.cluster();
    return Done{};
}

void SceneGame::edit(std::string path, std::string text) {
    replacedPath_ = std::move(path);
    replacementText_ = std::move(text);
}

void SceneGame::logProblems(const LoadReport& report) const {
    for (const Error& problem : report.problems) {
        logWarning("Scene", problem);
    }
}

std::string SceneGame::currentPath() const {
    const LoadedScenes* loaded = world.findResource<LoadedScenes>();
    return loaded == nullptr || loaded->scenes.empty() ? std::string{} : loaded->scenes.front().path;
}

/// Acquires the assets of the world's current scenes if these have changed.
void SceneGame::followAssets() {
    const LoadedScenes& loaded = world.resource<LoadedScenes>();
    const bool same =
        std::equal(loaded.scenes.begin(), loaded.scenes.end(), heldScenes_.begin(), heldScenes_.end(),
                   [](const LoadedScene& scene, SceneId id) { return scene.id == id; });
    if (same) return;
    heldScenes_.clear();
    for (const LoadedScene& scene : loaded.scenes) heldScenes_.push_back(scene.id);
    held_.follow(world, types);
    ticksToUnload_ = kUnloadTicks;
}

void SceneGame::restored() {
    heldScenes_.clear();
    followAssets();
}

void SceneGame::unloadLater() {
    if (ticksToUnload_ == 0 || --ticksToUnload_ > 0) return;
    held_.follow(world, types);  // assets that game code has used meanwhile
    assets.unloadUnused();
}

void SceneGame::onAssetsChanged(std::span<const AssetChange> changes) {
    const std::string current = currentPath();
    const auto isCurrent = [&](const AssetChange& change) {
        return change.kind == AssetKind::Scene && change.path == textId(current);
    };
    if (std::none_of(changes.begin(), changes.end(), isCurrent)) return;
    // If the file is invalid, the game continues unchanged.
    const Result<Path> file = assets.resolve(current);
    const Result<std::string> text = file ? readFile(*file) : Result<std::string>{file.error()};
    const Result<Json> json = text ? parseJson(*text, current) : Result<Json>{text.error()};
    if (!json) {
        logError("Scene", json.error());
        return;
    }
    follow(current, false);
}

void SceneGame::onLateUpdate(float) {
    followScenes();
    followAssets();
    unloadLater();
}

void SceneGame::followScenes() {
    SceneRequests& requests = world.resource<SceneRequests>();
    if (requests.empty()) return;
    const SceneRequests wanted = std::exchange(requests, {});
    if (wanted.quit) quit_ = true;
    if (wanted.close) closeOverlay(world);
    if (!wanted.next.empty()) {
        follow(std::string{world.texts().find(wanted.next)}, wanted.overlay);
    } else if (wanted.reload) {
        follow(currentPath(), false);
    }
}

void SceneGame::follow(const std::string& path, bool overlay) {
    if (!overlay) {
        if (const auto opened = openScene(path); !opened) logError("Scene", opened.error());
        return;
    }
    const auto opened = openOverlay(world, context(), path);
    opened ? logProblems(*opened) : logError("Scene", opened.error());
}

}  // namespace plumb
