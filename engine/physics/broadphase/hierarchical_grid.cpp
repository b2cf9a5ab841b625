#include "physics/broadphase/hierarchical_grid.hpp"

#include <bit>
#include <cmath>

#include "physics/broadphase/box_statistics.hpp"
#include "physics/broadphase/overlap.hpp"
#include "physics/broadphase/regions.hpp"

namespace plumb::physics {

namespace {

constexpr float kCoarser = 4.0f;  // ratio of the cell sizes of successive levels
constexpr float kMinCell = 0.1f;  // ratio to the spacing: smaller cells would not separate boxes better

bool fits(const BoxCells& sides) {
    return cellsFrom(sides[0], sides[2]) <= 2 && cellsFrom(sides[1], sides[3]) <= 2;
}

}  // namespace

HierarchicalGrid::Cell HierarchicalGrid::cellOf(const AABB& box, std::uint32_t finest) const {
    for (std::uint32_t level = finest; level + 1 < kLevels; ++level) {
        const float perMetre = levels_[level].perMetre;
        const BoxCells sides{cellAt(box.min.x, perMetre), cellAt(box.min.y, perMetre),
                             cellAt(box.max.x, perMetre), cellAt(box.max.y, perMetre)};
        if (fits(sides)) return {sides[0], sides[1], level};
    }
    return {0, 0, kLevels - 1};
}

std::uint32_t HierarchicalGrid::indexOf(const Cell& cell) const {
    const Level& level = levels_[cell.level];
    const std::uint32_t column = static_cast<std::uint32_t>(cell.x) & (level.columns - 1);
    const std::uint32_t row = static_cast<std::uint32_t>(cell.y) & (level.rows - 1);
    return level.firstCell + row * level.columns + column;
}

Vec2 HierarchicalGrid::alongRow(const LineSweep& sweep, double top, double bottom) {
    double first = 0.0;
    double last = 1.0;
    const double displacement = double{sweep.displacement.y};
    if (displacement != 0.0) {
        const double a = (top - double{sweep.half.y} - double{sweep.from.y}) / displacement;
        const double b = (bottom + double{sweep.half.y} - double{sweep.from.y}) / displacement;
        first = std::max(first, std::min(a, b));
        last = std::min(last, std::max(a, b));
        if (!(first <= last)) return {1.0f, 0.0f};
    }
    const double from = double{sweep.from.x} + double{sweep.displacement.x} * first;
    const double to = double{sweep.from.x} + double{sweep.displacement.x} * last;
    return {static_cast<float>(std::min(from, to)) - sweep.half.x,
            static_cast<float>(std::max(from, to)) + sweep.half.x};
}

void HierarchicalGrid::visitRegions(RegionVisitor& visitor) const {
    const Cell* last = nullptr;  // boxes of one cell are adjacent
    for (std::uint32_t place = 0; place < sorted_; ++place) {
        const Cell& cell = cells_[place];
        const float perMetre = levels_[cell.level].perMetre;
        if (rows_.isFree(place) || perMetre == 0.0f || (last != nullptr && *last == cell)) continue;
        last = &cell;
        const Vec2 corner{static_cast<float>(cell.x) / perMetre, static_cast<float>(cell.y) / perMetre};
        visitor.region({corner, corner + Vec2{1.0f, 1.0f} / perMetre});
    }
}

void HierarchicalGrid::clear() {
    clearRows();
    cells_.clear();
    for (Level& level : levels_) level.count = 0;
}

/// Chooses cell sizes for the boxes in order_, if the boxes changed much or the last choice is old.
void HierarchicalGrid::chooseSizes(const Proxies& proxies) {
    if (!choiceIsDue()) return;
    const BoxStatistics spread = statisticsOf(proxies, order_);
    aspect_ = spread.aspect;
    float extent = std::max(spread.extent, spread.spacing * kMinCell);
    for (Level& level : levels_) {
        level.perMetre = std::clamp(1.0f / extent, 1e-30f, 1e30f);
        extent *= kCoarser;
    }
    levels_[kLevels - 1].perMetre = 0.0f;  // a single cell for boxes that are too large for all others
}

/// Assigns a cell to each box in order_, and gives each grid about as many cells as it has boxes.
void HierarchicalGrid::chooseCells(const Proxies& proxies) {
    for (Level& level : levels_) level.count = 0;
    orderBoxes_.resize(order_.size() + order_.size() % 2);
    for (std::size_t i = 0; i < order_.size(); ++i) orderBoxes_[i] = usable(proxies.bounds[order_[i]]);
    orderSides_.resize(orderBoxes_.size());
    searches_.findCells(orderBoxes_, levels_[0].perMetre, orderSides_);
    orderCells_.resize(order_.size());
    for (std::size_t i = 0; i < order_.size(); ++i) {
        const BoxCells& sides = orderSides_[i];
        orderCells_[i] = fits(sides) ? Cell{sides[0], sides[1], 0} : cellOf(orderBoxes_[i], 1);
        ++levels_[orderCells_[i].level].count;
    }
    std::uint32_t cells = 0;
    for (Level& level : levels_) {
        level.firstCell = cells;
        level.columns = level.rows = 1;
        if (level.count == 0) continue;
        if (&level != &levels_[kLevels - 1]) {
            const float maximum = std::max(static_cast<float>(level.count / 4), 4.0f);
            const float columns = std::sqrt(static_cast<float>(level.count) * aspect_);
            level.columns = std::bit_ceil(static_cast<std::uint32_t>(std::clamp(columns, 4.0f, maximum)));
            level.rows = std::bit_ceil(std::max(level.count / level.columns, 4u));
        }
        cells += level.columns * level.rows;
    }
    starts_.assign(cells + 1, 0);
}

void HierarchicalGrid::sort(const Proxies& proxies, std::uint32_t spare, std::span<std::uint32_t> places,
                            std::uint32_t first) {
    chooseSizes(proxies);
    chooseCells(proxies);
    for (const Cell& cell : orderCells_) ++starts_[indexOf(cell) + 1];
    for (std::size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1] + spare;
    noteSorted(starts_.back());
    rows_.reset(sorted_);
    cells_.resize(sorted_);
    // While the cells are filled, starts_[c] is the next slot of cell c to write.
    for (std::size_t i = 0; i < order_.size(); ++i) {
        const std::uint32_t place = starts_[indexOf(orderCells_[i])]++;
        rows_.write(proxies, place, order_[i], orderBoxes_[i]);
        cells_[place] = orderCells_[i];
        places[order_[i]] = first + place;
    }
    for (std::size_t i = starts_.size() - 1; i > 0; --i) starts_[i] = starts_[i - 1] + spare;
    starts_[0] = 0;
}

/// A free slot in the cell, or else a new one after all cells.
std::uint32_t HierarchicalGrid::placeIn(const Cell& cell) {
    const std::uint32_t index = indexOf(cell);
    if (levels_[cell.level].count > 0) {
        for (std::uint32_t place = starts_[index]; place < starts_[index + 1]; ++place) {
            if (!rows_.isFree(place)) continue;
            cells_[place] = cell;
            return place;
        }
    }
    return rows_.addPlace();
}

bool HierarchicalGrid::take(const Proxies& proxies, std::span<std::uint32_t> arrivals, std::uint32_t moving,
                            std::span<std::uint32_t> places, std::uint32_t first) {
    const bool maxMove = moving > rows_.size() / 4 && rows_.size() > kFew;
    if (!maxMove && !isDue(arrivals.size())) {
        for (const std::uint32_t id : arrivals) {
            const AABB box = usable(proxies.bounds[id]);
            const std::uint32_t place = placeIn(cellOf(box));
            rows_.write(proxies, place, id, box);
            places[id] = first + place;
        }
        return false;
    }
    collect(arrivals);
    // Where most boxes move, they are sorted in each step anyway: no spare slots.
    sort(proxies, maxMove ? 0 : 1, places, first);
    return true;
}

std::uint32_t HierarchicalGrid::move(const Proxies& proxies, std::uint32_t place) {
    const std::uint32_t id = rows_.ids[place];
    const AABB box = usable(proxies.bounds[id]);
    const Cell cell = cellOf(box);
    if (place >= sorted_ || cell != cells_[place]) {
        rows_.erase(place);
        place = placeIn(cell);
    }
    rows_.write(proxies, place, id, box);
    return place;
}

}  // namespace plumb::physics
