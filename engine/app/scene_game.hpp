#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/game.hpp"
#include "app/game_content.hpp"
#include "app/project.hpp"
#include "scene/files/prefab.hpp"
#include "scene/files/scene_assets.hpp"
#include "scene/files/scene_file.hpp"

namespace plumb {

/// A game made of scene files: loads the first scene and performs the scene changes that the scenes request.
class SceneGame final : public Game {
public:
    /// @param firstScene  path of the first scene in the project; empty: the project's start scene
    explicit SceneGame(Project project, std::string firstScene = {}, std::uint64_t seed = 1,
                       const GameContent& content = engineContent());

    void onCreate() override;
    void onLateUpdate(float dt) override;
    void onAssetsChanged(std::span<const AssetChange> changes) override;

    /// Unloads all scenes and loads this one. Persistent entities are kept.
    /// @error the file cannot be read; the previous scenes are kept, unless the scene is one of them
    Result<Done> openScene(std::string_view path);
    /// Uses this text instead of a scene's file whenever the scene is opened, e.g. for unsaved changes of an
    /// editor. Errors in it are not logged.
    void edit(std::string path, std::string text);

    /// To be called after a snapshot was restored: loads the assets that the restored world references.
    void restored();
    void onLoaded() override { restored(); }
    /// Reads prefabs again when they are needed next.
    void reloadPrefabs() { prefabs_.forget(); }

    [[nodiscard]] const Project& project() const { return project_; }
    [[nodiscard]] bool quitRequested() const override { return quit_; }
    /// Why onCreate() could not open the first scene; it is not logged.
    [[nodiscard]] const std::optional<Error>& failure() const { return failure_; }
    [[nodiscard]] SceneContext context() { return {types, &prefabs_, project_.root}; }

private:
    void logProblems(const LoadReport& report) const;
    [[nodiscard]] std::string currentPath() const;
    void followAssets();
    void unloadLater();
    void followScenes();
    void follow(const std::string& path, bool overlay);

    Project project_;
    std::string firstScene_;
    // Set by edit(): path of a scene file, and the text that is loaded in its place.
    std::string replacedPath_, replacementText_;
    PrefabLibrary prefabs_;
    SceneAssets held_{assets};
    std::vector<SceneId> heldScenes_;  // the scenes whose assets are held
    int ticksToUnload_ = 0;  // ticks until unreferenced assets are unloaded; 0: no unloading is scheduled
    bool quit_ = false;
    std::optional<Error> failure_;
};

}  // namespace plumb
