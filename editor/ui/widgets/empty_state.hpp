#pragma once

#include <initializer_list>
#include <string>

#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// What a panel shows that has nothing to show: what is missing, how it comes to be, and buttons for that.
/// @param panel    its title; the buttons are "PANEL/empty/LABEL"
/// @param how      empty: the buttons say it all
/// @param actions  of the table, each with its keys
void emptyState(Ui& ui, const std::string& panel, const char* what, const char* how,
                std::initializer_list<std::string_view> actions = {});

}  // namespace plumb::editor::ui
