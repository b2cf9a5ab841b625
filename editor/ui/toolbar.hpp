#pragma once

#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// Draws the toolbar below the menus: groups of buttons, and a list of the groups for which the window is too
/// narrow.
/// @param top     px: upper edge of the toolbar
/// @param height  px
void drawToolbar(Ui& ui, float top, float height);

}  // namespace plumb::editor::ui
