#pragma once

#include "editor/model/assets/animation_edit.hpp"
#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// Draws one cell of an animation's sprite sheet as large as possible into the center of a box.
/// @param box  target rectangle, px on screen
void drawSheetCell(Ui& ui, const AnimationEdit& edit, const AnimationFrame& frame, const AABB& box);

}  // namespace plumb::editor::ui
