#include "editor/model/actions.hpp"

#include <vector>

#include "editor/model/actions/action_rows.hpp"

namespace plumb::editor {
namespace {

std::vector<Action> allRows() {
    std::vector<Action> rows;
    for (const auto rowsOfMenu : {fileActions(), editActions(), entityActions(), arrangeActions(),
                                  toolActions(), tileActions(), viewActions(), runActions()}) {
        rows.insert(rows.end(), rowsOfMenu.begin(), rowsOfMenu.end());
    }
    return rows;
}

bool counts(During during, const Workspace& w) {
    if (during == During::Always) return true;
    if (during == During::Halted) return w.debugger.halt() != nullptr;
    return (during == During::Tiles) == w.paintsTiles();
}

}  // namespace

std::span<const Action> actionTable() {
    static const std::vector<Action> table = allRows();
    return table;
}

const Action* findAction(std::string_view id) {
    if (id.empty()) return nullptr;  // separator lines have no id
    for (const Action& action : actionTable()) {
        if (action.id == id) return &action;
    }
    return nullptr;
}

bool runAction(Workspace& workspace, std::string_view id) {
    const Action* action = findAction(id);
    if (action == nullptr || !action->enabled(workspace)) return false;
    if (action->run == nullptr) {
        workspace.useTool(action->id);
    } else {
        action->run(workspace);
    }
    return true;
}

bool isOn(const Action& action, const Workspace& workspace) {
    if (action.on != nullptr) return action.on(workspace);
    return action.run == nullptr && toolTable()[workspace.toolIndex()].action == action.id;
}

bool runShortcut(Workspace& workspace, const Event& event) {
    // Shortcuts for only one state take precedence over general ones.
    for (const bool special : {true, false}) {
        for (const Action& action : actionTable()) {
            if ((action.during != During::Always) != special || !counts(action.during, workspace)) continue;
            if (!workspace.settings.keys.matches(action, event)) continue;
            if (runAction(workspace, action.id)) return true;
        }
    }
    return false;
}

}  // namespace plumb::editor
