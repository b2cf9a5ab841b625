#pragma once

#include <span>
#include <string_view>

#include "editor/model/input/shortcut.hpp"

namespace plumb::editor {

class Workspace;

/// When a shortcut counts, so that a key may mean one thing for entities and another for tiles.
enum class During : unsigned char { Always, Entities, Tiles };

/// One thing that a person can ask for: a row of the table that menus, toolbar, tooltips and shortcuts read.
struct Action {
    std::string_view id;     ///< "edit.undo"; empty: a line between two groups of a menu
    std::string_view menu;   ///< "Edit"
    std::string_view label;  ///< "Undo"
    Shortcut shortcut;
    bool (*enabled)(const Workspace& workspace) = nullptr;
    void (*run)(Workspace& workspace) = nullptr;       ///< null: takes the tool of that id
    bool (*on)(const Workspace& workspace) = nullptr;  ///< for what is a switch
    Shortcut alternative{};
    During during = During::Always;
};

std::span<const Action> actionTable();
const Action* findAction(std::string_view id);

/// Whether a switch is on, or a tool in the hand.
bool isOn(const Action& action, const Workspace& workspace);

/// Does what the id stands for; nothing when it is not possible now.
bool runAction(Workspace& workspace, std::string_view id);

/// Runs what the pressed keys stand for. @return whether there was something
bool runShortcut(Workspace& workspace, const Event& event);

}  // namespace plumb::editor
