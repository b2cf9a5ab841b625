#pragma once

#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// Draws the arrow beside the snap button; it opens a popup with snapItems().
void snapMenu(Ui& ui);
/// Draws the snap settings: snap target, angle step, grid size and color.
void snapItems(Ui& ui);

}  // namespace plumb::editor::ui
