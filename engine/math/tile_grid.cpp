#include "math/tile_grid.hpp"

#include <algorithm>
#include <utility>

namespace plumb {
namespace {

int chunksFor(int cells) { return (std::max(cells, 0) + TileGrid::kChunkSide - 1) / TileGrid::kChunkSide; }

bool isEmpty(const TileGrid::Chunk* chunk) {
    return chunk == nullptr ||
           std::all_of(chunk->cells.begin(), chunk->cells.end(), [](TileCell cell) { return cell == 0; });
}

}  // namespace

TileGrid::TileGrid(int width, int height)
    : width_{std::max(width, 0)},
      height_{std::max(height, 0)},
      columns_{chunksFor(width)},
      rows_{chunksFor(height)} {
    chunks_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
    rowStamps_.assign(static_cast<std::size_t>(rows_), nextStamp());
}

void TileGrid::set(int x, int y, TileCell cell) {
    if (!has(x, y)) return;
    std::shared_ptr<Chunk>& chunk = chunks_[chunkAt(x, y)];
    if ((chunk == nullptr ? 0 : chunk->at(x, y)) == cell) return;
    if (chunk == nullptr) {
        chunk = std::make_shared<Chunk>();
    } else if (chunk.use_count() > 1) {
        chunk = std::make_shared<Chunk>(*chunk);
    }
    chunk->cells[Chunk::slot(x, y)] = cell;
    chunk->stamp = nextStamp();
    rowStamps_[static_cast<std::size_t>(y / kChunkSide)] = chunk->stamp;
    ++version_;
}

void TileGrid::replaceCells(int width, int height, const std::vector<TileCell>& cells) {
    const std::uint32_t version = version_ + 1;
    *this = TileGrid{width, height};
    version_ = version;
    for (int y = 0; y < height_; ++y) {
        const TileCell* from = cells.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width_);
        for (int x = 0; x < width_; x += kChunkSide) {
            const int count = std::min(kChunkSide, width_ - x);
            if (std::all_of(from + x, from + x + count, [](TileCell cell) { return cell == 0; })) continue;
            std::shared_ptr<Chunk>& chunk = chunks_[chunkAt(x, y)];
            if (chunk == nullptr) {
                chunk = std::make_shared<Chunk>();
                chunk->stamp = nextStamp();
            }
            std::copy_n(from + x, count,
                        chunk->cells.begin() + static_cast<std::ptrdiff_t>(Chunk::slot(x, y)));
        }
    }
}

std::vector<TileCell> TileGrid::cells() const {
    std::vector<TileCell> all(cellCount());
    for (int y = 0; y < height_; ++y)
        copyRow(0, y, static_cast<std::size_t>(width_),
                all.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width_));
    return all;
}

void TileGrid::copyRow(int x, int y, std::size_t count, TileCell* into) const {
    const int end = x + static_cast<int>(count);
    while (x < end) {
        const int step = std::min(kChunkSide - (x & (kChunkSide - 1)), end - x);
        const Chunk* from = has(x, y) ? chunks_[chunkAt(x, y)].get() : nullptr;
        if (from == nullptr) {
            std::fill_n(into, step, 0u);
        } else {
            std::copy_n(from->cells.begin() + static_cast<std::ptrdiff_t>(Chunk::slot(x, y)), step, into);
        }
        x += step, into += step;
    }
}

std::shared_ptr<TileGrid::Chunk> TileGrid::filled(TileCell cell) {
    if (cell == 0) return nullptr;
    auto made = std::make_shared<Chunk>();
    made->cells.fill(cell);
    made->stamp = nextStamp();
    return made;
}

void TileGrid::put(int column, int row, std::shared_ptr<Chunk> chunk) {
    const int right = std::min(width_ - column * kChunkSide, kChunkSide);
    const int bottom = std::min(height_ - row * kChunkSide, kChunkSide);
    if (chunk != nullptr && (right < kChunkSide || bottom < kChunkSide)) {
        // Cells outside the grid are empty.
        chunk = std::make_shared<Chunk>(*chunk);
        for (int y = 0; y < kChunkSide; ++y) {
            for (int x = 0; x < kChunkSide; ++x) {
                if (x >= right || y >= bottom) chunk->cells[Chunk::slot(x, y)] = 0;
            }
        }
        chunk->stamp = nextStamp();
    }
    chunks_[chunkSlot(column, row)] = std::move(chunk);
    rowStamps_[static_cast<std::size_t>(row)] = nextStamp();
    ++version_;
}

void TileGrid::adopt(const TileGrid& from, int column, int row) {
    chunks_[chunkSlot(column, row)] = from.chunks_[chunkSlot(column, row)];
    rowStamps_[static_cast<std::size_t>(row)] = from.rowStamps_[static_cast<std::size_t>(row)];
    ++version_;
}

bool operator==(const TileGrid& a, const TileGrid& b) {
    if (a.width_ != b.width_ || a.height_ != b.height_) return false;
    return std::equal(a.chunks_.begin(), a.chunks_.end(), b.chunks_.begin(),
                      [](const auto& one, const auto& other) {
                          if (one == other) return true;
                          if (one == nullptr || other == nullptr)
                              return isEmpty(one.get()) && isEmpty(other.get());
                          return one->cells == other->cells;
                      });
}

}  // namespace plumb
