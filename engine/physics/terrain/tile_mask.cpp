#include "physics/terrain/tile_mask.hpp"

#include "core/assert.hpp"

namespace plumb::physics {

TileMask::TileMask(int width, int height)
    : width_{std::clamp(width, 0, kMaxSide)},
      height_{std::clamp(height, 0, std::min(kMaxSide, kMaxCells / std::max(width_, 1)))},
      columns_{(width_ + kSide - 1) / kSide},
      chunks_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>((height_ + kSide - 1) / kSide)) {}

bool TileMask::set(int x, int y, MaskCell cell) {
    PLUMB_ASSERT(knows(cell), "set a cell whose form, material and layers are in the palette");
    if (!has(x, y) || !knows(cell) || at(x, y) == cell) return false;
    std::shared_ptr<Chunk>& chunk = chunks_[chunkOf(x, y)];
    if (chunk == nullptr) {
        chunk = std::make_shared<Chunk>();
    } else if (chunk.use_count() > 1) {
        chunk = std::make_shared<Chunk>(*chunk);
    }
    (*chunk)[slot(x, y)] = cell;
    return true;
}

void TileMask::putPlain(int column, int row, MaskCell cell) {
    PLUMB_ASSERT(knows(cell), "put cells whose form, material and layers are in the palette");
    const auto at =
        static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
    if (cell == MaskCell{} || !knows(cell)) {
        chunks_[at] = nullptr;
        return;
    }
    auto known = std::find_if(plains_.begin(), plains_.end(),
                              [cell](const Plain& plain) { return plain.cell == cell; });
    if (known == plains_.end()) {
        known = plains_.insert(known, {cell, std::make_shared<Chunk>()});
        known->chunk->fill(cell);
    }
    chunks_[at] = known->chunk;
}

void TileMask::putChunk(int column, int row, const Chunk& cells) {
    if (std::all_of(cells.begin(), cells.end(), [&](MaskCell cell) { return cell == cells.front(); }))
        return putPlain(column, row, cells.front());
    PLUMB_ASSERT(std::all_of(cells.begin(), cells.end(), [this](MaskCell cell) { return knows(cell); }),
                 "put cells whose form, material and layers are in the palette");
    chunks_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
            static_cast<std::size_t>(column)] = std::make_shared<Chunk>(cells);
}

MaskCell TileMask::fullAround(int column, int row) const {
    const Chunk* chunk = chunkAt(column, row);
    const bool isInner = column > 0 && row > 0 && column + 1 < width_ / kSide && row + 1 < height_ / kSide;
    if (chunk == nullptr || !isInner || chunk->front().form != TileForm::Full) return {};
    if (std::none_of(plains_.begin(), plains_.end(),
                     [chunk](const Plain& plain) { return plain.chunk.get() == chunk; }))
        return {};
    for (int y = row - 1; y <= row + 1; ++y) {
        for (int x = column - 1; x <= column + 1; ++x) {
            if (chunkAt(x, y) != chunk) return {};
        }
    }
    return chunk->front();
}

void TileMask::setOutside(MaskCell cell) {
    const bool good = knows(cell) && (cell.form == TileForm::Empty || cell.form == TileForm::Full);
    PLUMB_ASSERT(good, "the cells beyond a terrain's border are empty or full");
    if (good) outside_ = cell;
}

void TileMask::copyTo(std::vector<MaskCell>& cells, CellRect rect) const {
    cells.assign(static_cast<std::size_t>(rect.width()) * static_cast<std::size_t>(rect.height()), outside_);
    const int x0 = std::max(rect.x0, 0);
    const int x1 = std::min(rect.x1, width_);
    if (x0 >= x1) return;
    for (int y = std::max(rect.y0, 0); y < std::min(rect.y1, height_); ++y) {
        auto to = cells.begin() + std::ptrdiff_t{y - rect.y0} * rect.width() + (x0 - rect.x0);
        for (int x = x0; x < x1;) {
            const int count = std::min(kSide - x % kSide, x1 - x);
            const Chunk* from = chunks_[chunkOf(x, y)].get();
            if (from == nullptr) {
                std::fill_n(to, count, MaskCell{});
            } else {
                std::copy_n(from->begin() + static_cast<std::ptrdiff_t>(slot(x, y)), count, to);
            }
            x += count, to += count;
        }
    }
}

}  // namespace plumb::physics
