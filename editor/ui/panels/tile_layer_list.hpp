#pragma once

#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// Draws the list of tile layers, front layer first, with the buttons for visibility, solo and lock, and the
/// settings of the active layer.
void drawTileLayerList(Ui& ui);

}  // namespace plumb::editor::ui
