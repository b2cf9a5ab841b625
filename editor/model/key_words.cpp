#include "editor/model/key_words.hpp"

#include "editor/model/actions.hpp"
#include "editor/model/workspace.hpp"

namespace plumb::editor {

std::string keysFor(const Workspace& workspace, std::string_view action) {
    const Action& row = *findAction(action);
    std::string keys = workspace.settings.keys.shownOf(row).text();
    return keys.empty() ? std::string{row.label} : keys;
}

}  // namespace plumb::editor
