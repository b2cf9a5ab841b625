#pragma once

#include <vector>

#include "assets/tileset.hpp"
#include "editor/model/document/document.hpp"
#include "editor/model/document/tile_paint.hpp"
#include "math/rect.hpp"
#include "math/tile_grid.hpp"

namespace plumb::editor {

/// The tile layer that tile tools work on: the selected one, else the one they worked on last, else the
/// first that is solid, else the first.
ObjectId activeTileLayer(const Document& document, const TilePaint& paint);

/// All tile layers, the one in front first.
std::vector<ObjectId> tileLayers(const Document& document);

/// The tiles of a layer, its terrain, and its tileset; null where it has none.
const TileGrid* gridOf(const Document& document, ObjectId layer);
const TileGrid* terrainOf(const Document& document, ObjectId layer);
const Tileset* tilesetOf(const Document& document, ObjectId layer);

/// The cell of a layer at a point of the world, and the box of a cell (px, world).
CellPlace cellAt(const Document& document, ObjectId layer, Vec2 point);
AABB boxOfCell(const Document& document, ObjectId layer, CellPlace place);
AABB boxOfCells(const Document& document, ObjectId layer, CellPlace a, CellPlace b);
/// The corner of cells nearest to a point: that of the upper left of the cell returned.
CellPlace cornerAt(const Document& document, ObjectId layer, Vec2 point);

}  // namespace plumb::editor
