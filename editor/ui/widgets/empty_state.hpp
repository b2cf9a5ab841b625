#pragma once

#include <initializer_list>
#include <string>

#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// Draws the content of an empty panel: what is missing, how to create it, and buttons for that.
/// @param panel    title of the panel; the widget path of a button is "PANEL/empty/LABEL"
/// @param how      instruction; may be empty
/// @param actions  ids of the actions of the buttons
void emptyState(Ui& ui, const std::string& panel, const char* what, const char* how,
                std::initializer_list<std::string_view> actions = {});

}  // namespace plumb::editor::ui
