#include "physics/broadphase/hierarchical_grid.hpp"

#include <bit>
#include <cmath>
#include <cstring>

namespace plumb::physics {

namespace {

constexpr float kCoarser = 4.0f;  // ratio of the cell sizes of successive levels
constexpr float kMinCell = 0.1f;  // ratio to the spacing: smaller cells would not separate boxes better

}  // namespace

// The compiler's vectors handle all four at once.
std::array<std::int32_t, 4> HierarchicalGrid::cellsOf(const AABB& box, float perMetre) {
    using Four [[gnu::vector_size(16)]] = float;
    using Cells = decltype(Four{} < Four{});
    static_assert(sizeof(Four) == sizeof(AABB));
    Four sides;
    std::memcpy(&sides, &box, sizeof(box));
    const Four most = 0x1p30f - Four{};
    sides *= perMetre;
    sides = sides < most ? sides : most;
    sides = sides > -most ? sides : -most;
    const Cells cells = __builtin_convertvector(sides, Cells);
    return std::bit_cast<std::array<std::int32_t, 4>>(
        cells + (sides < __builtin_convertvector(cells, Four)));  // true is -1
}

HierarchicalGrid::Cell HierarchicalGrid::cellOf(const AABB& box) const {
    for (std::uint32_t level = 0; level + 1 < kLevels; ++level) {
        const auto sides = cellsOf(box, levels_[level].perMetre);
        if (cellsFrom(sides[0], sides[2]) <= 2 && cellsFrom(sides[1], sides[3]) <= 2)
            return {sides[0], sides[1], level};
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

void HierarchicalGrid::visitRegions(const std::function<void(const AABB&)>& visit) const {
    const Cell* last = nullptr;  // boxes of one cell are adjacent
    for (std::uint32_t place = 0; place < sorted_; ++place) {
        const Cell& cell = cells_[place];
        const float perMetre = levels_[cell.level].perMetre;
        if (isFree(place) || perMetre == 0.0f || (last != nullptr && *last == cell)) continue;
        last = &cell;
        const Vec2 corner{static_cast<float>(cell.x) / perMetre, static_cast<float>(cell.y) / perMetre};
        visit({corner, corner + Vec2{1.0f, 1.0f} / perMetre});
    }
}

/// Chooses cell sizes, if the boxes changed much or the last choice is old.
void HierarchicalGrid::chooseSizes(const Proxies& proxies, std::span<const std::uint32_t> order) {
    const auto spread = newStatistics(proxies, order);
    if (!spread) return;
    aspect_ = spread->aspect;
    float extent = std::max(spread->extent, spread->spacing * kMinCell);
    for (Level& level : levels_) {
        level.perMetre = std::clamp(1.0f / extent, 1e-30f, 1e30f);
        extent *= kCoarser;
    }
    levels_[kLevels - 1].perMetre = 0.0f;  // a single cell for boxes that are too large for all others
}

/// Assigns a cell to each box, and gives each grid about as many cells as it has boxes.
void HierarchicalGrid::chooseCells(const Proxies& proxies, std::span<const std::uint32_t> order) {
    for (Level& level : levels_) level.count = 0;
    orderBoxes_.resize(order.size());
    orderCells_.resize(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        orderBoxes_[i] = usable(proxies.bounds[order[i]]);
        orderCells_[i] = cellOf(orderBoxes_[i]);
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

void HierarchicalGrid::sort(const Proxies& proxies, std::span<const std::uint32_t> order,
                            std::uint32_t moving, const PlaceList& list) {
    chooseSizes(proxies, order);
    chooseCells(proxies, order);
    // Where most boxes move, they are sorted in each step anyway: no free slots in each cell.
    const std::uint32_t spare = mostMove(moving) ? 0 : 1;
    for (const Cell& cell : orderCells_) ++starts_[indexOf(cell) + 1];
    for (std::size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1] + spare;
    reset(starts_.back(), order.size());
    cells_.resize(sorted_);
    // While the cells are filled, starts_[c] is the next slot of cell c to write.
    for (std::size_t i = 0; i < order.size(); ++i) {
        const std::uint32_t place = starts_[indexOf(orderCells_[i])]++;
        write(proxies, place, order[i], orderBoxes_[i]);
        cells_[place] = orderCells_[i];
        list.set(order[i], place);
    }
    for (std::size_t i = starts_.size() - 1; i > 0; --i) starts_[i] = starts_[i - 1] + spare;
    starts_[0] = 0;
}

/// A free slot in the cell, or else a new one after all cells.
std::uint32_t HierarchicalGrid::placeIn(const Cell& cell) {
    const std::uint32_t index = indexOf(cell);
    if (levels_[cell.level].count > 0) {
        for (std::uint32_t place = starts_[index]; place < starts_[index + 1]; ++place) {
            if (!isFree(place)) continue;
            cells_[place] = cell;
            return place;
        }
    }
    return addPlace();
}

std::uint32_t HierarchicalGrid::move(const Proxies& proxies, std::uint32_t place) {
    const std::uint32_t id = idAt(place);
    const AABB box = usable(proxies.bounds[id]);
    const Cell cell = cellOf(box);
    if (place >= sorted_ || cell != cells_[place]) {
        erase(place);
        place = placeIn(cell);
    }
    write(proxies, place, id, box);
    return place;
}

}  // namespace plumb::physics
