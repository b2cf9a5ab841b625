#include "physics/terrain/terrain_outlines.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace plumb::physics {

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
    if (!mask_.has(x, y)) return;
    const auto chunk = static_cast<std::uint32_t>(y / chunkCells_ * columns_ + x / chunkCells_);
    if (std::exchange(isDirty_[chunk], std::uint8_t{1}) == 0) dirty_.push_back(chunk);
}

void TerrainOutlines::set(int x, int y, MaskCell cell) {
    if (!mask_.set(x, y, cell)) return;
    for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) markDirty(x + dx, y + dy);
    }
}

std::span<const std::uint32_t> TerrainOutlines::update() {
    changed_.clear();
    std::sort(dirty_.begin(), dirty_.end());
    for (const std::uint32_t chunk : dirty_) {
        isDirty_[chunk] = 0;
        outlines_.build(mask_, cellsOf(chunk), fresh_.outline);
        pieces_.build(mask_, cellsOf(chunk), fresh_.pieces);
        if (fresh_ == chunks_[chunk]) continue;
        chunks_[chunk] = fresh_;  // a copy is as small as can be, and both keep their memory
        changed_.push_back(chunk);
    }
    dirty_.clear();
    return changed_;
}

}  // namespace plumb::physics
