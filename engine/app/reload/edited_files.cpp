#include "app/reload/edited_files.hpp"

#include <utility>

#include "app/game.hpp"
#include "app/game_content.hpp"
#include "core/log.hpp"

namespace plumb {

EditedFiles::EditedFiles(Game& game, GameContent* content) : game_{game}, content_{content} {
    if (content != nullptr) scripts_.emplace(content->scripts(), game.assets.root());
}

bool EditedFiles::look(double now) {
    game_.watchPrefabs();
    changes_ = game_.assets.pollChanges();
    // A scene may name components of scripts that were saved with it.
    scriptsChanged_ = scripts_ && (changes_.empty() ? scripts_->poll(now) : scripts_->look());
    return scriptsChanged_ || !changes_.empty();
}

void EditedFiles::take() {
    if (std::exchange(scriptsChanged_, false)) takeScripts();
    const std::vector<AssetChange> changes = std::exchange(changes_, {});
    if (!changes.empty()) game_.followChanges(changes);
}

void EditedFiles::takeScripts() {
    std::vector<Error> problems;
    const ContentChange change = content_->readScripts(game_.assets.root(), problems);
    game_.contentChanged(change);
    for (const Error& problem : problems) logError("Script", problem);
    if (problems.empty()) logNote("Script", "Reloaded the scripts");
}

}  // namespace plumb
