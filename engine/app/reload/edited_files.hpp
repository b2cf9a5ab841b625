#pragma once

#include <optional>
#include <vector>

#include "app/reload/script_watch.hpp"
#include "assets/asset_store.hpp"

namespace plumb {

class Game;
class GameContent;

/// Takes up the files of a project that are edited while its game runs: scripts, prefabs, scenes and assets.
class EditedFiles {
public:
    /// @param content  that of the game, whose scripts are read again when they change; null: they are not.
    /// Must outlive this
    EditedFiles(Game& game, GameContent* content);

    /// Looks for changed files. @param now  s, of any clock @return false if there is nothing for take()
    bool look(double now);
    /// To be called between ticks: lets the game use what look() has found. What cannot be read is logged
    /// and stays as it was.
    void take();

private:
    void takeScripts();

    Game& game_;
    GameContent* content_;
    std::optional<ScriptWatch> scripts_;
    std::vector<AssetChange> changes_;
    bool scriptsChanged_ = false;
};

}  // namespace plumb
