#pragma once

#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// Draws the toolbar below the menus: groups of buttons. Groups that do not fit into the window are in a list
/// at its right end.
/// @param top     px: upper edge of the toolbar
/// @param height  px
void drawToolbar(Ui& ui, float top, float height);

}  // namespace plumb::editor::ui
