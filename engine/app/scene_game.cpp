#include "app/scene_game.hpp"

#include <algorithm>
#include <utility>

#include "app/system_order.hpp"
#include "core/log.hpp"
#include "platform/paths.hpp"
#include "reflect/json.hpp"
#include "reflect/json_text.hpp"
#include "scene/game_random.hpp"
#include "scene/physics_state.hpp"
#include "scene/scene_requests.hpp"
#include "scene/systems/camera_system.hpp"
#include "scene/world_transform.hpp"

namespace plumb {

SceneGame::SceneGame(Project project, std::string firstScene, std::uint64_t seed)
    : project_{std::move(project)},
      firstScene_{firstScene.empty() ? project_.startScene : scenePath(firstScene)},
      prefabs_{types, project_.root} {
    assets = AssetStore{project_.root, engineAssets()};
    input.setMap(project_.actions);
    world.resource<GameRandom>().random = Random::seeded(seed);
    world.resource<PhysicsSettings>().gravity = project_.gravity;
    world.resource<PictureSize>().size = {static_cast<float>(project_.width),
                                          static_cast<float>(project_.height)};
    addAllSystems(world);
}

void SceneGame::onCreate() {
    if (firstScene_.empty()) {
        logError("Scene", Error{"project.json", "names no startScene",
                                "write \"startScene\": \"scenes/title.scene.json\""});
        failed_ = quit_ = true;
        return;
    }
    if (const auto opened = openScene(firstScene_); !opened) {
        logError("Scene", opened.error());
        failed_ = quit_ = true;
    }
}

Result<Done> SceneGame::openScene(std::string_view path) {
    // The new scene comes first: when it cannot be read, the old one goes on.
    const std::vector<SceneId> before = std::exchange(stack_, {});
    const bool again = sceneId(path) == sceneId(current_);
    if (again) {
        for (const SceneId scene : before) unloadScene(world, scene);
    }
    if (auto loaded = load(path); !loaded) {
        if (!again) stack_ = before;
        return loaded;
    }
    if (!again) {
        for (const SceneId scene : before) unloadScene(world, scene);
    }
    current_ = path;
    storePreviousTransforms(world);
    world.cluster();
    return Done{};
}

Result<Done> SceneGame::load(std::string_view path) {
    Result<LoadReport> report = loadSceneFile(world, context(), path);
    if (!report) return report.error();
    for (const Error& problem : report->problems) {
        logWarning("Scene", problem);
    }
    stack_.push_back(report->scene);
    assets.load(AssetKind::Scene, path);  // watched: editing it begins it anew
    return Done{};
}

void SceneGame::onAssetsChanged(std::span<const AssetChange> changes) {
    const auto isCurrent = [&](const AssetChange& change) {
        return change.kind == AssetKind::Scene && change.path == textId(current_);
    };
    if (std::none_of(changes.begin(), changes.end(), isCurrent)) return;
    // A file that cannot be read leaves the game as it is.
    const Result<Path> file = assets.resolve(current_);
    const Result<std::string> text = file ? readFile(*file) : Result<std::string>{file.error()};
    const Result<Json> json = text ? parseJson(*text, current_) : Result<Json>{text.error()};
    if (!json) {
        logError("Scene", json.error());
        return;
    }
    follow(std::string{current_}, false);
}

void SceneGame::onLateUpdate(float) {
    SceneRequests& requests = world.resource<SceneRequests>();
    if (requests.empty()) return;
    const SceneRequests wanted = std::exchange(requests, {});
    if (wanted.quit) quit_ = true;
    if (wanted.close && stack_.size() > 1) {
        unloadScene(world, stack_.back());
        stack_.pop_back();
    }
    if (!wanted.next.empty()) {
        follow(std::string{world.texts().find(wanted.next)}, wanted.overlay);
    } else if (wanted.reload) {
        follow(current_, false);
    }
}

void SceneGame::follow(const std::string& path, bool overlay) {
    const auto done = overlay ? load(path) : openScene(path);
    if (!done) logError("Scene", done.error());
}

}  // namespace plumb
