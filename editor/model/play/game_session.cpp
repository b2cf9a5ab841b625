#include "editor/model/play/game_session.hpp"

#include "app/scene_game.hpp"
#include "core/log.hpp"

namespace plumb::editor {
namespace {

class GameSession final : public PlaySession {
public:
    explicit GameSession(const Project& project) : game_{project} {
        game_.assets.logging = false;  // the editor has reported what it loaded of the project
    }

    /// The game is in that scene. The text stands for its file, now and when the game comes back to it.
    Result<Done> load(const std::string& path, const std::string& text) {
        game_.edit(path, text);
        if (Result<Done> opened = game_.openScene(path); !opened) return opened;
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
