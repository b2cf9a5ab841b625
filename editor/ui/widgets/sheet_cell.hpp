#pragma once

#include "editor/model/assets/animation_edit.hpp"
#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// Draws one cell of an animation's sheet into a box, as large as fits, in its middle.
/// @param box  px on screen
void drawSheetCell(Ui& ui, const AnimationEdit& edit, const AnimationFrame& frame, const AABB& box);

}  // namespace plumb::editor::ui
