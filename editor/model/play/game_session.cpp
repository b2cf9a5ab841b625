#include "editor/model/play/game_session.hpp"

#include "app/scene_game.hpp"
#include "core/log.hpp"

namespace plumb::editor {
namespace {

class GameSession final : public PlaySession {
public:
    GameSession(const Project& project, const GameContent& content) : game_{project, {}, 1, content} {
        game_.assets.logging = false;  // the editor has already logged the problems of these assets
    }

    /// Opens a scene. `text` replaces the content of the scene's file, also when the game opens the scene
    /// again.
    Result<Done> load(const std::string& path, const std::string& text) {
        game_.edit(path, text);
        if (Result<Done> opened = game_.openScene(path); !opened) return opened;
        restored();  // loads the assets, so that the world is complete before the first tick
        return Done{};
    }

    [[nodiscard]] World& world() override { return game_.world; }
    [[nodiscard]] AssetStore* assets() override { return &game_.assets; }
    void tick(const InputFrame& input) override { tickGame(game_, input); }
    void restored() override { game_.restored(); }
    void contentChanged(const ContentChange& change) override { game_.contentChanged(change); }
    bool reload(const std::string& path, const std::string& text) override { return load(path, text).ok(); }

private:
    SceneGame game_;
};

}  // namespace

std::unique_ptr<PlaySession> makeGameSession(const Project& project, const std::string& path,
                                             const std::string& text, const GameContent& content) {
    auto session = std::make_unique<GameSession>(project, content);
    if (const Result<Done> loaded = session->load(path, text); !loaded) {
        logError("Editor", loaded.error());
        return nullptr;
    }
    return session;
}

}  // namespace plumb::editor
