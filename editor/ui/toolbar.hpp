#pragma once

#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// The bar below the menus: groups of buttons, and a list of those groups for which the window is too narrow.
/// @param top     px, where it begins
/// @param height  px
void drawToolbar(Ui& ui, float top, float height);

}  // namespace plumb::editor::ui
