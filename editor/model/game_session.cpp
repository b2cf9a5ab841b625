#include "editor/model/game_session.hpp"

#include "app/scene_game.hpp"
#include "core/log.hpp"
#include "scene/loaded_scene.hpp"
#include "scene/scene_file.hpp"
#include "scene/world_transform.hpp"

namespace plumb::editor {
namespace {

class GameSession final : public PlaySession {
public:
    explicit GameSession(const Project& project) : game_{project} {
        game_.assets.logging = false;  // the editor has told what it loaded of the project
    }

    /// The game is in that scene, and the text is in its place; the file is not read, which may be large.
    Result<Done> load(const std::string& path, const std::string& text) {
        path_ = path;
        text_ = text;
        const auto* loaded = game_.world.findResource<LoadedScenes>();
        if (loaded == nullptr || loaded->scenes.empty()) {
            addScene(game_.world, path);
        } else if (Result<Done> opened = game_.openScene(path); !opened) {
            return opened;
        }
        if (Result<Done> placed = placeText(); !placed) return placed;
        restored();  // what it makes in the world is there from the beginning
        return Done{};
    }

    [[nodiscard]] World& world() override { return game_.world; }
    [[nodiscard]] AssetStore* assets() override { return &game_.assets; }
    /// A level that is begun anew, or come back to, is the one that is edited, not its file.
    void tick(const InputFrame& input) override {
        tickGame(game_, input);
        const LoadedScene* now = lowest();
        if (now == nullptr || now->rest == known_) return;
        if (now->path == path_) {
            if (const Result<Done> placed = placeText(); !placed) logError("Editor", placed.error());
        }
        known_ = lowest()->rest;
    }
    /// Another scene may need other assets; no scene was asked for between two ticks.
    void restored() override {
        game_.onLateUpdate(0.0f);
        if (const LoadedScene* now = lowest()) known_ = now->rest;
    }
    bool reload(const std::string& path, const std::string& text) override { return load(path, text).ok(); }

private:
    Result<Done> placeText() {
        unloadScene(game_.world, sceneId(path_));
        const Result<LoadReport> report = loadScene(game_.world, game_.context(), path_, text_);
        if (!report) return report.error();
        loadAssets(game_.world, game_.types, game_.assets);
        storePreviousTransforms(game_.world);
        game_.world.cluster();
        return Done{};
    }

    [[nodiscard]] const LoadedScene* lowest() const {
        const auto* loaded = game_.world.findResource<LoadedScenes>();
        return loaded == nullptr || loaded->scenes.empty() ? nullptr : &loaded->scenes.front();
    }

    std::string path_;
    std::string text_;
    std::shared_ptr<const SceneRest> known_;  // of the scene at the bottom: each loading makes one of its own
    SceneGame game_;
};

}  // namespace

std::unique_ptr<PlaySession> makeGameSession(const Project& project, const std::string& path,
                                             const std::string& text) {
    auto session = std::make_unique<GameSession>(project);
    if (const Result<Done> loaded = session->load(path, text); !loaded) {
        logError("Editor", loaded.error());
        return nullptr;
    }
    return session;
}

}  // namespace plumb::editor
