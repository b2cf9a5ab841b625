#pragma once

#include <imgui.h>

#include "assets/tileset.hpp"
#include "editor/ui/ui.hpp"
#include "math/rect.hpp"
#include "math/tile_grid.hpp"

namespace plumb::editor::ui {

/// Draws one tile, turned over as its cell says. Nothing where there is no graphics card, or no tile.
/// @param box  px on screen
void drawTile(Ui& ui, ImDrawList& list, const Tileset& tileset, TileCell cell, const AABB& box,
              ImU32 tint = IM_COL32_WHITE);

}  // namespace plumb::editor::ui
