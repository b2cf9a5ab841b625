#pragma once

#include <span>
#include <string_view>

#include "editor/model/shortcut.hpp"

namespace plumb::editor {

class Workspace;

/// One thing that a person can ask for: a row of the table that menus, toolbar, tooltips and shortcuts read.
struct Action {
    std::string_view id;     ///< "edit.undo"
    std::string_view menu;   ///< "Edit"; empty: in no menu
    std::string_view label;  ///< "Undo"
    Shortcut shortcut;
    Shortcut alternative;
    bool (*enabled)(const Workspace& workspace);
    void (*run)(Workspace& workspace);
    bool (*on)(const Workspace& workspace) = nullptr;  ///< for what is a switch
};

std::span<const Action> actionTable();
const Action* findAction(std::string_view id);

/// Does what the id stands for; nothing when it is not possible now.
bool runAction(Workspace& workspace, std::string_view id);

/// Runs what the pressed keys stand for. @return whether there was something
bool runShortcut(Workspace& workspace, const Event& event);

}  // namespace plumb::editor
