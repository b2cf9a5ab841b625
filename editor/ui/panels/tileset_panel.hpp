#pragma once

#include <memory>
#include <span>
#include <vector>

#include "assets/tileset.hpp"
#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// A page of the Tileset panel, with the state of an unfinished text input or drag.
class TilesetPage {
public:
    virtual ~TilesetPage() = default;
    virtual void draw(Ui& ui, const Tileset& tileset, std::span<const int> chosen) = 0;
};

/// Page "Tile": collision shape, material and properties of the selected tiles.
std::unique_ptr<TilesetPage> makeTileMeaningPage();
/// Page "Animation": the frames of an animated tile.
std::unique_ptr<TilesetPage> makeTileAnimationPage();
/// Draws the page "Terrain": the terrains of the tileset, and the neighbour mask of each tile.
/// @param terrain  id of the edited terrain; changed by a click on another one
void drawTerrainPage(Ui& ui, const Tileset& tileset, std::span<const int> chosen, int& terrain);

}  // namespace plumb::editor::ui
