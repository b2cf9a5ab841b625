#pragma once

#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// Draws the strip below the toolbar while a prefab is edited: its name, and a button to leave it.
/// @param top    px: upper edge of the strip
/// @param width  px: width of the window
/// @return       px: height of the strip; 0 while a scene is edited
float drawPrefabStrip(Ui& ui, float top, float width);

}  // namespace plumb::editor::ui
