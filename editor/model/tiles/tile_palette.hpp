#pragma once

#include "assets/tileset.hpp"
#include "editor/model/document/tile_stamp.hpp"
#include "math/vec2.hpp"

namespace plumb::editor {

/// How the tiles of a set lie to choose from: as in its picture, or in rows of eight where each tile has a
/// picture of its own.
struct TilePalette {
    int columns = 1;
    int rows = 0;
    int count = 0;
    Vec2 tileSize{16.0f, 16.0f};     ///< px
    const Tileset* grown = nullptr;  ///< of a picture that became wider: it knows where its tiles are

    /// The tile's number; -1 where there is none.
    [[nodiscard]] int tileAt(CellPlace place) const;
    [[nodiscard]] CellPlace placeOf(int tile) const;
    /// The place nearest to a point (px of the unzoomed palette).
    [[nodiscard]] CellPlace nearest(Vec2 point) const;
    [[nodiscard]] Vec2 size() const;  ///< px
    /// The tiles between two places, in any order of corners.
    [[nodiscard]] TileStamp stamp(CellPlace a, CellPlace b) const;
};

TilePalette paletteOf(const Tileset& tileset);

}  // namespace plumb::editor
