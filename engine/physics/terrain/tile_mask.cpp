#include "physics/terrain/tile_mask.hpp"

#include "core/assert.hpp"

namespace plumb::physics {

TileMask::TileMask(int width, int height)
    : width_{std::clamp(width, 0, kMaxSide)},
      height_{std::clamp(height, 0, std::min(kMaxSide, kMaxCells / std::max(width_, 1)))},
      cells_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_)) {}

bool TileMask::set(int x, int y, MaskCell cell) {
    PLUMB_ASSERT(knows(cell), "set a cell whose form, material and layers are in the palette");
    if (!has(x, y) || !knows(cell) || cells_[slot(x, y)] == cell) return false;
    cells_[slot(x, y)] = cell;
    return true;
}

void TileMask::setOutside(MaskCell cell) {
    const bool good = knows(cell) && (cell.form == TileForm::Empty || cell.form == TileForm::Full);
    PLUMB_ASSERT(good, "beyond a terrain's border is nothing or full cells");
    if (good) outside_ = cell;
}

void TileMask::copyTo(std::vector<MaskCell>& cells, CellRect rect) const {
    cells.assign(static_cast<std::size_t>(rect.width()) * static_cast<std::size_t>(rect.height()), outside_);
    const int x0 = std::max(rect.x0, 0);
    const int x1 = std::min(rect.x1, width_);
    if (x0 >= x1) return;
    for (int y = std::max(rect.y0, 0); y < std::min(rect.y1, height_); ++y) {
        const auto to = cells.begin() + std::ptrdiff_t{y - rect.y0} * rect.width() + (x0 - rect.x0);
        const auto from = cells_.begin() + static_cast<std::ptrdiff_t>(slot(x0, y));
        std::copy(from, from + (x1 - x0), to);
    }
}

}  // namespace plumb::physics
