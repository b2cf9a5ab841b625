#pragma once

#include <vector>

#include "assets/tileset.hpp"
#include "editor/model/document/document.hpp"
#include "editor/model/document/tile_paint.hpp"
#include "math/rect.hpp"
#include "math/tile_grid.hpp"

namespace plumb::editor {

/// Returns the tile layer that tile tools edit: the selected one, else the one edited last, else the first
/// one with a TileCollider, else the first.
ObjectId activeTileLayer(const Document& document, const TilePaint& paint);

/// Returns all tile layers, the front-most first.
std::vector<ObjectId> tileLayers(const Document& document);

/// Return the tiles, terrain and tileset of a layer, null if it has none.
const TileGrid* gridOf(const Document& document, ObjectId layer);
const TileGrid* terrainOf(const Document& document, ObjectId layer);
const Tileset* tilesetOf(const Document& document, ObjectId layer);

/// Return the cell of a layer at a world point, and the box of a cell (world px).
CellPlace cellAt(const Document& document, ObjectId layer, Vec2 point);
AABB boxOfCell(const Document& document, ObjectId layer, CellPlace place);
AABB boxOfCells(const Document& document, ObjectId layer, CellPlace a, CellPlace b);
/// Returns the grid corner nearest to a point, as the cell whose upper left corner it is.
CellPlace cornerAt(const Document& document, ObjectId layer, Vec2 point);

}  // namespace plumb::editor
