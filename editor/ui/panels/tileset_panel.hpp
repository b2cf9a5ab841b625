#pragma once

#include <memory>
#include <span>
#include <vector>

#include "assets/tileset.hpp"
#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// A page of the Tileset panel; it keeps what is being typed and dragged there.
class TilesetPage {
public:
    virtual ~TilesetPage() = default;
    virtual void draw(Ui& ui, const Tileset& tileset, std::span<const int> chosen) = 0;
};

/// What the chosen tiles are to bodies and to the game.
std::unique_ptr<TilesetPage> makeTileMeaningPage();
/// The frames that are shown instead of a tile.
std::unique_ptr<TilesetPage> makeTileAnimationPage();
/// The terrains of the set, and which tile stands for which neighbours.
/// @param terrain  the id of the one that is edited; changed by a click on another one
void drawTerrainPage(Ui& ui, const Tileset& tileset, std::span<const int> chosen, int& terrain);

}  // namespace plumb::editor::ui
