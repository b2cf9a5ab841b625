#pragma once

#include "assets/tileset.hpp"
#include "editor/model/document/tile_stamp.hpp"
#include "math/vec2.hpp"

namespace plumb::editor {

/// Arrangement of a tileset's tiles in the palette: as in the tileset's image, or in rows of eight if each
/// tile has an image file of its own.
struct TilePalette {
    int columns = 1;
    int rows = 0;
    int count = 0;                   ///< number of tiles
    Vec2 tileSize{16.0f, 16.0f};     ///< px: size of a tile without zoom
    const Tileset* grown = nullptr;  ///< the tileset if its image was widened, to place its tiles; else null

    /// Returns the id of the tile in a cell of the palette; -1 if the cell is empty.
    [[nodiscard]] int tileAt(CellPlace place) const;
    /// Returns the cell of the palette that shows a tile.
    [[nodiscard]] CellPlace placeOf(int tile) const;
    /// Returns the cell nearest to a point (px of the palette without zoom).
    [[nodiscard]] CellPlace nearest(Vec2 point) const;
    [[nodiscard]] Vec2 size() const;  ///< px without zoom
    /// Returns the tiles in the box with the opposite corner cells `a` and `b` as a stamp.
    [[nodiscard]] TileStamp stamp(CellPlace a, CellPlace b) const;
};

/// Computes the arrangement for a tileset.
TilePalette paletteOf(const Tileset& tileset);

}  // namespace plumb::editor
