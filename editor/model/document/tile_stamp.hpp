#pragma once

#include <vector>

#include "editor/model/document/cell_selection.hpp"
#include "math/tile_grid.hpp"

namespace plumb::editor {

/// The tile or pattern of tiles that is painted. Empty cells of a pattern leave the layer's cells unchanged.
struct TileStamp {
    int width = 1;
    int height = 1;
    std::vector<TileCell> cells{cellOf(0)};  ///< row by row, top row first

    [[nodiscard]] TileCell at(int x, int y) const {
        return cells[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                     static_cast<std::size_t>(x)];
    }
    [[nodiscard]] bool single() const { return width == 1 && height == 1; }
    friend bool operator==(const TileStamp&, const TileStamp&) = default;
};

/// Copies a rectangle of a grid, given by two opposite corner cells. Cells outside the grid are empty.
TileStamp stampFrom(const TileGrid& grid, CellPlace a, CellPlace b);

/// Returns a grid of another size with the same cells at the same coordinates; cells outside are dropped.
TileGrid resized(const TileGrid& grid, int width, int height);

TileStamp flippedX(const TileStamp& stamp);
TileStamp flippedY(const TileStamp& stamp);
/// Rotates by 90 degrees clockwise.
TileStamp turned(const TileStamp& stamp);
/// Rotates by 90 degrees counterclockwise.
TileStamp turnedBack(const TileStamp& stamp);

}  // namespace plumb::editor
