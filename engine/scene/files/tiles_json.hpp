#pragma once

#include "core/result.hpp"
#include "math/tile_grid.hpp"
#include "reflect/json_fwd.hpp"

namespace plumb {

/// Returns the JSON of a grid: {"width", "height", "rows": ["1 2 0 5x", …]}, one string per row; x, y and d
/// after a number flip the tile horizontally, vertically and diagonally. Above 256 x 256 cells "blocks" of
/// 128 x 128 cells replace the rows; empty ones are omitted. A block is "column row =5" if all cells are
/// equal, otherwise "column row data" with zlib data in base64; so a change affects few lines. Older files
/// have "base64": zlib data for each band of rows.
Json tilesToJson(const TileGrid& grid);

/// A grid, and the error that was corrected while reading it; `problem` is empty if there was none.
struct ReadTiles {
    TileGrid grid;
    std::string problem;
    std::string remedy;
};

/// Reads a grid. Short rows are filled with empty cells, long ones are cut, and `problem` reports it.
/// @error the grid cannot be read; `where` is the key, e.g. "rows[3]"
Result<ReadTiles> tilesFromJson(const Json& json);

}  // namespace plumb
