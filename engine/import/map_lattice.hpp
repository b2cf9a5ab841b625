#pragma once

#include "import/tiled_map.hpp"
#include "math/rect.hpp"

namespace plumb {

/// The grid in whose cells the tiles of a map lie. That of an orthogonal map is the map's own. Those of other
/// maps are finer: at most every other cell holds a tile, and rows from the top are the order of drawing.
/// Source: Tiled, "TMX Map Format": stagger axis, stagger index and side length of hexagons
class MapLattice {
public:
    explicit MapLattice(const tiled::Map& map);

    struct Cell {
        int column = 0;
        int row = 0;

        friend bool operator==(const Cell&, const Cell&) = default;
    };
    /// Cells from `first` on.
    struct Area {
        Cell first;
        int width = 0;
        int height = 0;
    };

    /// Returns the lattice's cell for a cell of the map; coordinates may be below zero.
    [[nodiscard]] Cell cellOf(int x, int y) const;
    /// Returns the cells of the lattice around a rectangle of cells of the map.
    [[nodiscard]] Area areaOf(int x, int y, int width, int height) const;
    /// Returns the area that a rectangle of cells of the map covers, px.
    [[nodiscard]] Rect boxOf(int x, int y, int width, int height) const;

    [[nodiscard]] int cellWidth() const { return cellWidth_; }  ///< px
    [[nodiscard]] int cellHeight() const { return cellHeight_; }
    /// px from the lower edge of a lattice's cell down to that of the map's cell, on which tiles stand.
    [[nodiscard]] int drop() const { return tileHeight_ - cellHeight_; }

private:
    [[nodiscard]] bool isShifted(int index) const { return ((index & 1) != 0) != staggersEven_; }

    tiled::Orientation orientation_;
    bool staggersX_;
    bool staggersEven_;
    int mapHeight_;  ///< cells; an isometric map of more rows begins farther right
    int tileWidth_;  ///< px
    int tileHeight_;
    int cellWidth_ = 1;
    int cellHeight_ = 1;
};

/// Returns the area that the camera may show, px: the map, or for an infinite map the box around its tiles.
Rect boundsOf(const tiled::Map& map);

}  // namespace plumb
