#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "physics/broadphase/partitioned_broad_phase.hpp"

namespace plumb::physics {

/// A hierarchical grid: a few grids, each with cells four times as large as the one before. The best choice
/// where boxes have similar sizes and all move fast. A box is stored in the finest grid in which it spans at
/// most two cells along each axis, in the cell of its top-left corner. Each grid is wrapped to a torus with
/// about as many cells as it has boxes, so the world may have any size; boxes of different places in one cell
/// are told apart by their bounds. Cells may have a spare slot; a box that finds none in its new cell is
/// stored after all cells. Source: C. Ericson, "Real-Time Collision Detection", 2005, 7.1.3 (hashed storage)
/// and 7.2 (hierarchical grids)
class HierarchicalGrid : public SortedRows<HierarchicalGrid> {
public:
    HierarchicalGrid() : SortedRows{4} {}

    // Interface for PartitionedBroadPhase.
    void sort(const Proxies& proxies, std::span<const std::uint32_t> order, std::uint32_t moving,
              const PlaceList& list);
    std::uint32_t move(const Proxies& proxies, std::uint32_t place);
    void visitRegions(const std::function<void(const AABB&)>& visit) const;

    // Interface for SortedRows and RowBroadPhase.
    std::uint32_t freePlace(const AABB& box) { return placeIn(cellOf(box)); }
    [[nodiscard]] bool areNear(std::uint32_t a, std::uint32_t b) const {
        return b < sorted_ && cells_[a].level == cells_[b].level && cells_[a].y == cells_[b].y &&
               static_cast<std::uint32_t>(cells_[b].x) - static_cast<std::uint32_t>(cells_[a].x) <=
                   kNearCells;
    }
    template <class Visit>
    void visitNear(const AABB& box, const LineSweep* sweep, std::uint32_t from, const Visit& visit) const;

private:
    static constexpr std::uint32_t kNearCells = 12;
    static constexpr std::uint32_t kLevels = 10;  // the last one is a single cell

    /// The cell of a box.
    struct Cell {
        std::int32_t x = 0;
        std::int32_t y = 0;
        std::uint32_t level = 0;
        friend bool operator==(const Cell&, const Cell&) = default;
    };
    struct Level {
        float perMetre = 0.0f;      ///< cells per m
        std::uint32_t columns = 1;  ///< powers of two, as `rows`
        std::uint32_t rows = 1;
        std::uint32_t firstCell = 0;  ///< index in starts_
        std::uint32_t count = 0;      ///< number of boxes
    };

    /// The left, top, right and bottom side of a box in cells, rounded down and clamped to 2^30.
    static std::array<std::int32_t, 4> cellsOf(const AABB& box, float perMetre);
    [[nodiscard]] Cell cellOf(const AABB& box) const;
    [[nodiscard]] std::uint32_t indexOf(const Cell& cell) const;
    /// Calls visit with the slots of `wide` cells of a row, beginning at column `left`.
    template <class Visit>
    void visitRow(const Level& level, std::int32_t row, std::int32_t left, std::uint32_t wide,
                  const Visit& visit) const;
    template <class Visit>
    void visitLevel(const Level& level, const AABB& box, const LineSweep* sweep, std::uint32_t from,
                    const Visit& visit) const;
    /// The interval of x that the sweep covers while it may overlap boxes of a row.
    static Vec2 alongRow(const LineSweep& sweep, double top, double bottom);
    void chooseSizes(const Proxies& proxies, std::span<const std::uint32_t> order);
    void chooseCells(const Proxies& proxies, std::span<const std::uint32_t> order);
    std::uint32_t placeIn(const Cell& cell);

    Level levels_[kLevels];
    std::vector<std::uint32_t> starts_;  ///< by cell: its first slot; one more entry marks the end
    std::vector<Cell> cells_;            ///< by slot
    float aspect_ = 1.0f;  ///< ratio of the width to the height of the area that the boxes are spread over

    std::vector<AABB> orderBoxes_;  ///< of the ids that are sorted
    std::vector<Cell> orderCells_;
};

/// The number of cells from `first` to `last`, which may differ by more than an int can hold.
inline std::uint32_t cellsFrom(std::int32_t first, std::int32_t last) {
    return static_cast<std::uint32_t>(last) - static_cast<std::uint32_t>(first) + 1;
}

template <class Visit>
void HierarchicalGrid::visitRow(const Level& level, std::int32_t row, std::int32_t left, std::uint32_t wide,
                                const Visit& visit) const {
    const std::uint32_t first =
        level.firstCell + (static_cast<std::uint32_t>(row) & (level.rows - 1)) * level.columns;
    const std::uint32_t column = static_cast<std::uint32_t>(left) & (level.columns - 1);
    const std::uint32_t* cells = starts_.data() + first;
    if (wide >= level.columns) {
        visit(cells[0], cells[level.columns]);
    } else if (column + wide <= level.columns) {
        visit(cells[column], cells[column + wide]);
    } else {
        visit(cells[column], cells[level.columns]);
        visit(cells[0], cells[column + wide - level.columns]);
    }
}

template <class Visit>
void HierarchicalGrid::visitLevel(const Level& level, const AABB& box, const LineSweep* sweep,
                                  std::uint32_t from, const Visit& visit) const {
    const std::uint32_t begin = starts_[level.firstCell];
    const std::uint32_t end = starts_[level.firstCell + level.columns * level.rows];
    if (end <= from) return;
    // A box spans at most two cells, so one that begins in the next cell to the left or above may reach in.
    const auto sides = cellsOf(box, level.perMetre);
    std::int32_t left = sides[0] - 1;
    const std::int32_t top = sides[1] - 1;
    std::uint32_t wide = cellsFrom(left, sides[2]);
    const std::uint32_t high = cellsFrom(top, sides[3]);
    if (high > level.rows || high > level.count / 8 + 2) return visit(std::max(begin, from), end);
    for (std::uint32_t i = 0; i < high; ++i) {
        const std::int32_t row = top + static_cast<std::int32_t>(i);
        if (sweep != nullptr) {
            const double size = 1.0 / double{level.perMetre};
            const Vec2 span = alongRow(*sweep, (row - 1.0) * size, (row + 3.0) * size);
            if (span.x > span.y) continue;
            // One more cell on each side to allow for rounding.
            const auto ends = cellsOf({{span.x, 0.0f}, {span.y, 0.0f}}, level.perMetre);
            left = ends[0] - 2;
            wide = cellsFrom(left, ends[2] + 1);
        }
        visitRow(level, row, left, wide,
                 [&](std::uint32_t a, std::uint32_t b) { visit(std::max(a, from), b); });
    }
}

template <class Visit>
void HierarchicalGrid::visitNear(const AABB& box, const LineSweep* sweep, std::uint32_t from,
                                 const Visit& visit) const {
    for (const Level& level : levels_) {
        if (level.count > 0) visitLevel(level, box, sweep, from, visit);
    }
    if (places() > sorted_) visit(std::max(sorted_, from), places());
}

}  // namespace plumb::physics
