#pragma once

#include <span>

#include "assets/autotile.hpp"
#include "editor/model/commands/paint_tiles.hpp"

namespace plumb::editor {

/// What painting terrain changes: the terrain itself, and the tiles in and around it that follow. A tile that
/// was painted over terrain by hand stays until the terrain asks for another tile there.
///
/// @param terrain  of the layer, as large as `cells`
/// @param wanted   ids, each place once; 0 takes the terrain away
PaintTiles::Change terrainChange(const TileGrid& cells, const TileGrid& terrain, const Autotile& autotile,
                                 std::span<const PaintTiles::Cell> wanted);

/// Gives every cell the tile that the terrain asks for, also where it was painted over by hand.
PaintTiles::Change retiled(const TileGrid& cells, const TileGrid& terrain, const Autotile& autotile);

}  // namespace plumb::editor
