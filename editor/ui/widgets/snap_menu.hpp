#pragma once

#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// The arrow beside the button that switches snapping: to what things snap, and the grid itself.
void snapMenu(Ui& ui);
/// What its list has.
void snapItems(Ui& ui);

}  // namespace plumb::editor::ui
