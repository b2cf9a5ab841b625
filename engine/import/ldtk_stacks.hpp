#pragma once

#include <vector>

#include "import/ldtk_project.hpp"
#include "math/tile_grid.hpp"

namespace plumb {

/// The tiles of one LDtk layer, which may overlap and be off the grid, sorted by height into stacked levels.
/// Such a level (not a game level) has a grid with one tile per cell, and a list of tiles off the grid.
struct LdtkStacks {
    struct Level {
        TileGrid cells;                        ///< grid of the layer's size; 0 x 0 if it has no tile
        std::vector<const ldtk::Tile*> loose;  ///< tiles off the grid, with the drawing order of `cells`
        int count = 0;                         ///< number of cells that are not empty
    };
    std::vector<Level> levels;  ///< in drawing order
};

/// Maximum number of stacked levels. Tiles above are added to `loose` of the highest level, in file order.
inline constexpr int kMaxStackedTiles = 1000;

/// Sorts the tiles of a layer into stacks.
/// @param tileSize   size of the layer's tiles, px; may be larger than its cells
/// @param tileCount  number of tiles in the tileset; tiles whose id is not below it are put in `loose`
LdtkStacks stackTiles(const ldtk::Layer& layer, int tileSize, int tileCount);

}  // namespace plumb
