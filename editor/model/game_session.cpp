#include "editor/model/game_session.hpp"

#include "app/scene_game.hpp"
#include "core/log.hpp"
#include "scene/scene_file.hpp"
#include "scene/world_transform.hpp"

namespace plumb::editor {
namespace {

class GameSession final : public PlaySession {
public:
    explicit GameSession(const Project& project) : game_{project} {
        game_.assets.logging = false;  // the editor has told what it loaded of the project
    }

    /// Opens the file, so that the game knows which scene it is in, and puts the text in its place.
    Result<Done> load(const std::string& path, const std::string& text) {
        if (Result<Done> opened = game_.openScene(path); !opened) return opened;
        unloadScene(game_.world, sceneId(path));
        const Result<LoadReport> report = loadScene(game_.world, game_.context(), path, text);
        if (!report) return report.error();
        loadAssets(game_.world, game_.types, game_.assets);
        storePreviousTransforms(game_.world);
        game_.world.cluster();
        restored();  // what it makes in the world is there from the beginning
        return Done{};
    }

    [[nodiscard]] World& world() override { return game_.world; }
    [[nodiscard]] AssetStore* assets() override { return &game_.assets; }
    void tick(const InputFrame& input) override { tickGame(game_, input); }
    /// Another scene may need other assets; no scene was asked for between two ticks.
    void restored() override { game_.onLateUpdate(0.0f); }
    bool reload(const std::string& path, const std::string& text) override { return load(path, text).ok(); }

private:
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
