#pragma once

#include <cstddef>
#include <vector>

#include "editor/model/document/cell_selection.hpp"
#include "math/tile_grid.hpp"

namespace plumb::editor {

/// The cells from one to another: no holes, each once.
std::vector<CellPlace> lineOfCells(CellPlace from, CellPlace to);
/// All cells between two corners, in any order of corners, that lie in the grid.
std::vector<CellPlace> boxOfCells(const TileGrid& grid, CellPlace a, CellPlace b);
/// Those of the box whose middle lies in its ellipse.
std::vector<CellPlace> ellipseOfCells(const TileGrid& grid, CellPlace a, CellPlace b);
/// The corner that makes the box from `from` a square, as large as its longer side.
CellPlace squareCorner(CellPlace from, CellPlace to);

/// How many cells one fill changes at most: its undo keeps each of them.
inline constexpr std::size_t kMostFilled = std::size_t{1} << 22;

/// The cells that a bucket fills: those connected to `from` through equal neighbours beside them.
/// @param terrain  where it has one, cells of equal terrain are equal; null: only tiles count
/// @param most     it ends with about so many, the nearest ones
std::vector<CellPlace> connectedCells(const TileGrid& grid, const TileGrid* terrain, CellPlace from,
                                      std::size_t most = kMostFilled);
/// All cells of the grid that are equal to that one, in the same sense.
std::vector<CellPlace> equalCells(const TileGrid& grid, const TileGrid* terrain, CellPlace to);
/// Those of them that are at most so many columns and rows away.
std::vector<CellPlace> equalCellsNear(const TileGrid& grid, const TileGrid* terrain, CellPlace to,
                                      int columns, int rows);

}  // namespace plumb::editor
