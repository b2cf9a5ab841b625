#pragma once

#include "core/result.hpp"
#include "math/tile_grid.hpp"
#include "reflect/json_fwd.hpp"

namespace plumb {

/// A grid as files hold it: {"width", "height", "rows": ["1 2 0 5x", …]}, one text a row; x, y and d behind a
/// number mirror the tile left-right, top-bottom and along its diagonal. Past 256 x 256 cells the rows become
/// "blocks" of 128 x 128 cells, those that are not empty: "3 0 =5" where all cells are equal, else "3 0 " and
/// a zlib block in base64, so that a change far away leaves the other lines as they are. Older files have
/// "base64", a zlib block for each band of rows.
Json tilesToJson(const TileGrid& grid);

/// A grid and what had to be mended in it; `problem` is empty when nothing was wrong.
struct ReadTiles {
    TileGrid grid;
    std::string problem;
    std::string remedy;
};

/// Rows that are too short are filled with empty cells, too long ones are cut: the problem says so.
/// @error no grid can be made; the place is the key, e.g. "rows[3]"
Result<ReadTiles> tilesFromJson(const Json& json);

}  // namespace plumb
