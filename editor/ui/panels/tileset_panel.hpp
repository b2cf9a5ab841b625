#pragma once

#include <span>
#include <vector>

#include "assets/tileset.hpp"
#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

// The pages of the Tileset panel.

/// What the chosen tiles are to bodies and to the game.
void drawTileMeaning(Ui& ui, const Tileset& tileset, std::span<const int> chosen);
/// The frames that are shown instead of a tile.
void drawTileAnimation(Ui& ui, const Tileset& tileset, std::span<const int> chosen);
/// The terrains of the set, and which tile stands for which neighbours.
/// @param terrain  the id of the one that is edited; changed by a click on another one
void drawTerrainPage(Ui& ui, const Tileset& tileset, std::span<const int> chosen, int& terrain);

}  // namespace plumb::editor::ui
