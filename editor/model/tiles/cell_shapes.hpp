#pragma once

#include <cstddef>
#include <vector>

#include "editor/model/document/cell_selection.hpp"
#include "math/tile_grid.hpp"

namespace plumb::editor {

/// Returns the cells of a line, both ends included, without gaps or duplicates.
std::vector<CellPlace> lineOfCells(CellPlace from, CellPlace to);
/// Returns all cells of the grid in the box with the opposite corners `a` and `b`, both included.
std::vector<CellPlace> boxOfCells(const TileGrid& grid, CellPlace a, CellPlace b);
/// Returns the cells of that box whose center lies in the ellipse inscribed in the box.
std::vector<CellPlace> ellipseOfCells(const TileGrid& grid, CellPlace a, CellPlace b);
/// Returns `to`, moved so that the box from `from` is a square with the longer side of the original box.
CellPlace squareCorner(CellPlace from, CellPlace to);

/// Maximum number of cells that one fill changes, as its undo step stores each of them.
inline constexpr std::size_t kMostFilled = std::size_t{1} << 22;

/// Returns the cells of a flood fill: those connected to `from` through equal cells, by shared edges.
/// @param terrain  cells with the same terrain are equal, whatever their tiles; null: only tiles are compared
/// @param most     the search stops at about this number of cells, the nearest ones
std::vector<CellPlace> connectedCells(const TileGrid& grid, const TileGrid* terrain, CellPlace from,
                                      std::size_t most = kMostFilled);
/// Returns all cells of the grid that are equal to the cell `to`, compared as in `connectedCells`.
std::vector<CellPlace> equalCells(const TileGrid& grid, const TileGrid* terrain, CellPlace to);
/// Returns the cells of `equalCells` at most `columns` and `rows` away from `to`.
std::vector<CellPlace> equalCellsNear(const TileGrid& grid, const TileGrid* terrain, CellPlace to,
                                      int columns, int rows);

}  // namespace plumb::editor
