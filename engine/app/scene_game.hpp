#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/game.hpp"
#include "app/project.hpp"
#include "scene/files/prefab.hpp"
#include "scene/files/scene_assets.hpp"
#include "scene/files/scene_file.hpp"

namespace plumb {

/// A game made of saved scenes: loads the first one and goes where the scenes lead.
class SceneGame final : public Game {
public:
    /// @param firstScene  path in the project; empty for the project's start scene
    explicit SceneGame(Project project, std::string firstScene = {}, std::uint64_t seed = 1);

    void onCreate() override;
    void onLateUpdate(float dt) override;
    void onAssetsChanged(std::span<const AssetChange> changes) override;

    /// Takes all scenes away and loads this one. Persistent entities stay.
    /// @error the file cannot be read at all; the scenes before are still there
    Result<Done> openScene(std::string_view path);
    /// From now on a text stands for the file of one scene, whenever the game goes there: an editor has
    /// changed it or plays what is not saved. What is wrong with it is not logged.
    void edit(std::string path, std::string text);

    [[nodiscard]] const Project& project() const { return project_; }
    [[nodiscard]] bool quitRequested() const override { return quit_; }
    [[nodiscard]] bool failed() const { return failed_; }
    [[nodiscard]] SceneContext context() { return {types, &prefabs_, project_.root}; }

private:
    void tell(const LoadReport& report) const;
    [[nodiscard]] std::string currentPath() const;
    void followAssets();
    void unloadLater();
    void followScenes();
    void follow(const std::string& path, bool overlay);

    Project project_;
    std::string firstScene_;
    std::string editedPath_, editedText_;
    PrefabLibrary prefabs_;
    SceneAssets held_{assets};
    std::vector<SceneId> followed_;  // the scenes whose assets are held
    int unloadIn_ = 0;               // ticks until what no scene names is unloaded; 0 for nothing to unload
    bool quit_ = false;
    bool failed_ = false;
};

}  // namespace plumb
