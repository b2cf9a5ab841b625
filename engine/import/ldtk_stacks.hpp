#pragma once

#include <vector>

#include "import/ldtk_project.hpp"
#include "math/tile_grid.hpp"

namespace plumb {

/// The tiles of one layer of LDtk, which may lie over each other and off the grid, as layers of the engine,
/// which hold one tile a cell: so many grids as tiles are stacked, and the tiles that fit no cell between
/// them.
struct LdtkStacks {
    struct Level {
        TileGrid cells;                        ///< of the whole layer; without a cell when it has no tile
        std::vector<const ldtk::Tile*> loose;  ///< drawn in the same order as the grid, or above it
        int count = 0;                         ///< cells that are not empty
    };
    std::vector<Level> levels;  ///< in the order of drawing
};

/// Tiles that lie deeper over each other than this lie loose in the highest level, in the file's order.
inline constexpr int kMaxStackedTiles = 1000;

/// @param tileSize  px of the layer's tiles, which may be larger than its cells
LdtkStacks stackTiles(const ldtk::Layer& layer, int tileSize, int tileCount);

}  // namespace plumb
