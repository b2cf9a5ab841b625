#pragma once

#include <imgui.h>

#include "assets/tileset.hpp"
#include "editor/ui/ui.hpp"
#include "math/rect.hpp"
#include "math/tile_grid.hpp"

namespace plumb::editor::ui {

/// Draws one tile with the flips and rotation of its cell. Draws
/// nothing without a graphics device or for an empty cell.
/// @param box  target rectangle, px on screen
void drawTile(Ui& ui, ImDrawList& list, const Tileset& tileset, TileCell cell, const AABB& box,
              ImU32 tint = IM_COL32_WHITE);

}  // namespace plumb::editor::ui
