#pragma once

#include <span>
#include <string_view>

#include "editor/model/input/shortcut.hpp"

namespace plumb::editor {

class Workspace;

/// When a shortcut is active: always, or only while the current tool edits entities or tiles, or while the
/// game is stopped at a line of a script, so that one key can have a different function in each case.
enum class During : unsigned char { Always, Entities, Tiles, Halted };

/// A user action: a row of the table from which menus, toolbar, tooltips and shortcuts are built.
struct Action {
    std::string_view id;     ///< "edit.undo"; empty: a separator line in a menu
    std::string_view menu;   ///< menu that lists it, e.g. "Edit"; empty: none
    std::string_view label;  ///< "Undo"
    Shortcut shortcut;
    bool (*enabled)(const Workspace& workspace) = nullptr;  ///< null only for a separator line
    void (*run)(Workspace& workspace) = nullptr;            ///< null: activates the tool of that id
    bool (*on)(const Workspace& workspace) = nullptr;       ///< state of a toggle; null: not a toggle
    Shortcut alternative{};                                 ///< second shortcut
    During during = During::Always;
};

std::span<const Action> actionTable();
/// Returns the action of this id; null if there is none.
const Action* findAction(std::string_view id);

/// True if the action is a toggle that is on, or activates the tool that is active now.
bool isOn(const Action& action, const Workspace& workspace);

/// Runs the action with this id. @return false if there is none or it is disabled now
bool runAction(Workspace& workspace, std::string_view id);

/// Runs the first enabled action whose shortcut matches the event. @return true if one ran
bool runShortcut(Workspace& workspace, const Event& event);

}  // namespace plumb::editor
