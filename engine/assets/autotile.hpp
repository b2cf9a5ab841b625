#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "assets/tileset.hpp"
#include "math/tile_grid.hpp"

namespace plumb {

/// Chooses the tiles of terrain. A cell's tile depends on the terrain around it and on its place alone:
/// whatever the order in which terrain came to be there, the same terrain gives the same tiles.
class Autotile {
public:
    /// The terrain ids of a cell (in the middle) and its eight neighbours, in rows.
    using Around = std::array<std::uint8_t, 9>;

    explicit Autotile(const Tileset& tileset);

    /// @return  nothing where no terrain decides
    [[nodiscard]] std::optional<TileCell> cellFor(const Around& around, int x, int y) const;
    /// The same, from all of a layer's terrain, which goes on beyond its border.
    [[nodiscard]] std::optional<TileCell> cellAt(const TileGrid& terrain, int x, int y) const;

    /// The terrain that a tile belongs to; 0 for none.
    [[nodiscard]] int terrainOf(TileCell cell) const;
    /// Whether the terrain lies on the corners of cells, each stored in the cell to its lower right.
    [[nodiscard]] bool onCorners(int terrain) const;

private:
    struct Variant {
        int tile = 0;
        double upTo = 0.0;  ///< sum of the weights so far
    };
    struct Rules {
        bool known = false;
        TerrainMode mode = TerrainMode::Blob;
        std::vector<std::vector<Variant>> choices;
        std::array<std::uint16_t, 256> choiceOf{};  ///< by mask
    };
    [[nodiscard]] static Rules rulesOf(const Terrain& terrain, const Tileset& tileset);
    [[nodiscard]] std::uint8_t maskFor(const Around& around, int terrain) const;
    [[nodiscard]] int terrainFor(const Around& around) const;

    std::vector<Rules> rules_;  // by terrain id
    std::vector<std::uint8_t> terrainOfTile_;
};

/// Terrain as the tiles of a layer show it, for layers that were painted by hand.
TileGrid terrainFromTiles(const TileGrid& cells, const Tileset& tileset);

}  // namespace plumb
