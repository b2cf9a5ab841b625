#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "assets/tileset.hpp"
#include "math/tile_grid.hpp"

namespace plumb {

/// Selects the tiles of terrain. A cell's tile depends only on the cell's position and on the terrain in and
/// around it, not on the order in which the terrain was painted.
class Autotile {
public:
    /// Terrain ids of a cell (index 4) and its eight neighbours, row by row.
    using Around = std::array<std::uint8_t, 9>;

    explicit Autotile(const Tileset& tileset);

    /// Returns the tile for a cell at (x, y); no value if no terrain determines it.
    [[nodiscard]] std::optional<TileCell> cellFor(const Around& around, int x, int y) const;
    /// Returns the tile for a cell of a layer's terrain, which is continued beyond the layer's border; no
    /// value if no terrain determines it.
    [[nodiscard]] std::optional<TileCell> cellAt(const TileGrid& terrain, int x, int y) const;

    /// Returns the id of the terrain that a tile belongs to; 0: none.
    [[nodiscard]] int terrainOf(TileCell cell) const;
    /// True if the terrain's mode is Corners: a terrain id then belongs to the upper left corner of its cell.
    [[nodiscard]] bool onCorners(int terrain) const;

private:
    struct Variant {
        int tile = 0;
        double upTo = 0.0;  ///< sum of the weights up to and including this variant
    };
    struct Rules {
        bool known = false;  ///< the tileset has a terrain with this id
        TerrainMode mode = TerrainMode::Blob;
        std::vector<std::vector<Variant>> choices;  ///< lists of tiles with the same mask
        std::array<std::uint16_t, 256> choiceOf{};  ///< index in `choices`, indexed by mask of neighbours
    };
    [[nodiscard]] static Rules rulesOf(const Terrain& terrain, const Tileset& tileset);
    [[nodiscard]] std::uint8_t maskFor(const Around& around, int terrain) const;
    [[nodiscard]] int terrainFor(const Around& around) const;

    std::vector<Rules> rules_;  // indexed by terrain id
    std::vector<std::uint8_t> terrainOfTile_;
};

/// Determines the terrain from the tiles of a layer, for layers that were painted tile by tile.
TileGrid terrainFromTiles(const TileGrid& cells, const Tileset& tileset);

}  // namespace plumb
