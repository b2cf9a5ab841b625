#pragma once

#include <span>

#include "assets/autotile.hpp"
#include "editor/model/commands/paint_tiles.hpp"

namespace plumb::editor {

/// Computes the change of painting terrain: the terrain ids, and the autotiled tiles in the painted cells and
/// around these. A tile that the user painted over terrain stays until its autotiled tile changes.
///
/// @param terrain  terrain ids of the layer, as large as `cells`
/// @param wanted   terrain ids to paint, each cell once; 0 removes the terrain
PaintTiles::Change terrainChange(const TileGrid& cells, const TileGrid& terrain, const Autotile& autotile,
                                 std::span<const PaintTiles::Cell> wanted);

/// Computes the change that replaces the tile of every terrain cell by its autotiled tile, also those that
/// the user painted over.
PaintTiles::Change retiled(const TileGrid& cells, const TileGrid& terrain, const Autotile& autotile);

}  // namespace plumb::editor
