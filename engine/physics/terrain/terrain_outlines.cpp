#include "physics/terrain/terrain_outlines.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "core/task_pool.hpp"

namespace plumb::physics {
namespace {

constexpr std::size_t kWorthSharing = 1024;  // chunks: fewer are built before another thread wakes
constexpr std::size_t kPart = 64;            // chunks that a thread takes at a time

}  // namespace

TerrainOutlines::TerrainOutlines(TileMask mask, int chunkCells)
    : mask_{std::move(mask)},
      chunkCells_{std::clamp(chunkCells, 4, 128)},
      columns_{(mask_.width() + chunkCells_ - 1) / chunkCells_},
      rows_{(mask_.height() + chunkCells_ - 1) / chunkCells_} {
    chunks_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
    isDirty_.assign(chunks_.size(), 1);
    dirty_.resize(chunks_.size());
    std::iota(dirty_.begin(), dirty_.end(), 0u);
}

CellRect TerrainOutlines::cellsOf(std::uint32_t chunk) const {
    const int x = static_cast<int>(chunk) % columns_ * chunkCells_;
    const int y = static_cast<int>(chunk) / columns_ * chunkCells_;
    return {x, y, std::min(x + chunkCells_, mask_.width()), std::min(y + chunkCells_, mask_.height())};
}

void TerrainOutlines::markDirty(int x, int y) {
    if (!mask_.cells().has(x, y)) return;
    const auto chunk = static_cast<std::uint32_t>(y / chunkCells_ * columns_ + x / chunkCells_);
    if (std::exchange(isDirty_[chunk], std::uint8_t{1}) == 0) dirty_.push_back(chunk);
}

void TerrainOutlines::set(int x, int y, MaskCell cell) {
    if (!mask_.set(x, y, cell)) return;
    for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) markDirty(x + dx, y + dy);
    }
}

bool TerrainOutlines::makeChunk(std::uint32_t chunk, Maker& maker) {
    const int column = static_cast<int>(chunk) % columns_, row = static_cast<int>(chunk) / columns_;
    if (chunkCells_ == kChunkCells && mask_.isPlain(column, row)) {
        maker.fresh.clear();
    } else {
        maker.builder.build(mask_, cellsOf(chunk), maker.fresh);
    }
    if (maker.fresh == chunks_[chunk]) return false;
    chunks_[chunk] = maker.fresh;  // a copy has no spare capacity, and both vectors keep their memory
    return true;
}

std::span<const std::uint32_t> TerrainOutlines::update(TaskPool* pool) {
    changed_.clear();
    std::sort(dirty_.begin(), dirty_.end());
    const auto make = [this](std::size_t first, std::size_t last, Maker& maker) {
        for (std::size_t i = first; i < last; ++i) isDirty_[dirty_[i]] = makeChunk(dirty_[i], maker) ? 1 : 0;
    };
    if (pool == nullptr || dirty_.size() < kWorthSharing) {
        make(0, dirty_.size(), makers_.front());
    } else {
        makers_.resize(std::max(makers_.size(), static_cast<std::size_t>(pool->threads())));
        const std::size_t parts = (dirty_.size() + kPart - 1) / kPart;
        pool->run(static_cast<int>(parts), [&](int part, int thread) {
            const std::size_t first = static_cast<std::size_t>(part) * kPart;
            make(first, std::min(first + kPart, dirty_.size()), makers_[static_cast<std::size_t>(thread)]);
        });
        makers_.resize(1);
    }
    for (const std::uint32_t chunk : dirty_) {
        if (std::exchange(isDirty_[chunk], std::uint8_t{0}) != 0) changed_.push_back(chunk);
    }
    dirty_.clear();
    return changed_;
}

}  // namespace plumb::physics
