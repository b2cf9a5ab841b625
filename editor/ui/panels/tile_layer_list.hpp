#pragma once

#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// The tile layers, the one in front first: which is in hand, seen, alone, locked, and how it looks.
void drawTileLayerList(Ui& ui);

}  // namespace plumb::editor::ui
