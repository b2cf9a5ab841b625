#include "editor/model/document/tile_stamp.hpp"

#include <algorithm>

namespace plumb::editor {
namespace {

/// Returns a stamp of another shape; `from(x, y)` returns the old cell that moves to (x, y).
template <class From, class Change>
TileStamp rearranged(const TileStamp& stamp, int width, int height, From from, Change change) {
    TileStamp made{width, height, {}};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const CellPlace place = from(x, y);
            const TileCell cell = stamp.at(place.x, place.y);
            made.cells.push_back(cell == 0 ? cell : change(cell));
        }
    }
    return made;
}

/// Rotates a cell by 90 degrees clockwise. A cell is drawn flipped across the diagonal first, then in x and
/// y. The rotation toggles the diagonal flip; the new x flip is the inverse of the old y flip, and the new y
/// flip is the old x flip.
TileCell turnedCell(TileCell cell) {
    const bool flipX = (cell & kTileFlipX) != 0;
    const bool flipY = (cell & kTileFlipY) != 0;
    TileCell made = (cell & ~kTileFlips) | ((cell & kTileFlipDiagonal) ^ kTileFlipDiagonal);
    if (!flipY) made |= kTileFlipX;
    if (flipX) made |= kTileFlipY;
    return made;
}

}  // namespace

TileStamp stampFrom(const TileGrid& grid, CellPlace a, CellPlace b) {
    const CellPlace from{std::min(a.x, b.x), std::min(a.y, b.y)};
    TileStamp stamp{std::abs(a.x - b.x) + 1, std::abs(a.y - b.y) + 1, {}};
    for (int y = 0; y < stamp.height; ++y) {
        for (int x = 0; x < stamp.width; ++x) {
            stamp.cells.push_back(grid.at(from.x + x, from.y + y));
        }
    }
    return stamp;
}

TileGrid resized(const TileGrid& grid, int width, int height) {
    TileGrid made{width, height};
    for (int row = 0; row < std::min(grid.chunkRows(), made.chunkRows()); ++row) {
        for (int column = 0; column < std::min(grid.chunkColumns(), made.chunkColumns()); ++column) {
            if (const TileGrid::Chunk* chunk = grid.chunk(column, row))
                made.put(column, row, std::make_shared<TileGrid::Chunk>(*chunk));
        }
    }
    return made;
}

TileStamp flippedX(const TileStamp& stamp) {
    return rearranged(
        stamp, stamp.width, stamp.height,
        [&](int x, int y) {
            return CellPlace{stamp.width - 1 - x, y};
        },
        [](TileCell cell) { return cell ^ kTileFlipX; });
}

TileStamp flippedY(const TileStamp& stamp) {
    return rearranged(
        stamp, stamp.width, stamp.height,
        [&](int x, int y) {
            return CellPlace{x, stamp.height - 1 - y};
        },
        [](TileCell cell) { return cell ^ kTileFlipY; });
}

TileStamp turned(const TileStamp& stamp) {
    return rearranged(
        stamp, stamp.height, stamp.width,
        [&](int x, int y) {
            return CellPlace{y, stamp.height - 1 - x};
        },
        &turnedCell);
}

TileStamp turnedBack(const TileStamp& stamp) { return turned(turned(turned(stamp))); }

}  // namespace plumb::editor
