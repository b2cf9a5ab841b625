#include "physics/terrain/tile_mask.hpp"

#include <algorithm>

#include "core/assert.hpp"

namespace plumb::physics {

TileMask::TileMask(int width, int height)
    : cells_{std::clamp(width, 0, kMaxSide),
             std::clamp(height, 0, std::min(kMaxSide, kMaxCells / std::clamp(width, 1, kMaxSide)))} {}

bool TileMask::set(int x, int y, MaskCell cell) {
    PLUMB_ASSERT(knows(cell), "set a cell whose form, material and layers are in the palette");
    if (!cells_.has(x, y) || !knows(cell) || at(x, y) == cell) return false;
    cells_.set(x, y, numberOf(cell));
    return true;
}

void TileMask::putPlain(int column, int row, MaskCell cell) {
    PLUMB_ASSERT(knows(cell), "put cells whose form, material and layers are in the palette");
    if (cell == MaskCell{} || !knows(cell)) return cells_.put(column, row, nullptr);
    auto known = std::find_if(plains_.begin(), plains_.end(),
                              [&](const auto& plain) { return plain->cells.front() == numberOf(cell); });
    if (known == plains_.end()) known = plains_.insert(known, TileGrid::filled(numberOf(cell)));
    cells_.put(column, row, *known);
}

void TileMask::putChunk(int column, int row, const Chunk& cells) {
    if (std::all_of(cells.begin(), cells.end(), [&](MaskCell cell) { return cell == cells.front(); }))
        return putPlain(column, row, cells.front());
    PLUMB_ASSERT(std::all_of(cells.begin(), cells.end(), [this](MaskCell cell) { return knows(cell); }),
                 "put cells whose form, material and layers are in the palette");
    auto chunk = std::make_shared<TileGrid::Chunk>();
    std::transform(cells.begin(), cells.end(), chunk->cells.begin(), numberOf);
    cells_.put(column, row, std::move(chunk));
}

bool TileMask::isPlain(int column, int row) const {
    const TileGrid::Chunk* chunk = cells_.chunk(column, row);
    if (chunk == nullptr) return true;
    const bool isInner = column > 0 && row > 0 && column + 1 < width() / TileGrid::kChunkSide &&
                         row + 1 < height() / TileGrid::kChunkSide;
    if (!isInner || maskCellOf(chunk->cells.front()).form != TileForm::Full) return false;
    for (int y = row - 1; y <= row + 1; ++y) {
        for (int x = column - 1; x <= column + 1; ++x) {
            if (cells_.chunk(x, y) != chunk) return false;  // only uniform chunks are shared within a grid
        }
    }
    return true;
}

}  // namespace plumb::physics
