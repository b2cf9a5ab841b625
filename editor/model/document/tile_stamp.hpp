#pragma once

#include <vector>

#include "editor/model/document/cell_selection.hpp"
#include "math/tile_grid.hpp"

namespace plumb::editor {

/// The tiles that are painted: one, or a pattern of several. Empty cells of a pattern leave what is there.
struct TileStamp {
    int width = 1;
    int height = 1;
    std::vector<TileCell> cells{cellOf(0)};  ///< in rows, top row first

    [[nodiscard]] TileCell at(int x, int y) const {
        return cells[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                     static_cast<std::size_t>(x)];
    }
    [[nodiscard]] bool single() const { return width == 1 && height == 1; }
    friend bool operator==(const TileStamp&, const TileStamp&) = default;
};

/// The stamp of a part of a grid, given by two corners in any order; cells outside the grid are empty.
TileStamp stampFrom(const TileGrid& grid, CellPlace a, CellPlace b);

/// The same cells from the top left on, more or fewer of them.
TileGrid resized(const TileGrid& grid, int width, int height);

TileStamp flippedX(const TileStamp& stamp);
TileStamp flippedY(const TileStamp& stamp);
/// A quarter turn clockwise.
TileStamp turned(const TileStamp& stamp);
/// A quarter turn the other way.
TileStamp turnedBack(const TileStamp& stamp);

}  // namespace plumb::editor
