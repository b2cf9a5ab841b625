#pragma once

#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// The strip below the toolbar while a prefab is edited: which one, and the way back.
/// @param top    px, where it begins
/// @param width  px, of the window
/// @return       px, how high it is: 0 while a scene is edited
float drawPrefabStrip(Ui& ui, float top, float width);

}  // namespace plumb::editor::ui
