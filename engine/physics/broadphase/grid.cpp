#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "physics/broadphase/row_broad_phase.hpp"

namespace plumb::physics {

namespace {

constexpr float kCoarser = 4.0f;  // ratio of the cell sizes of successive levels
constexpr float kMinCell = 0.1f;  // ratio to the spacing: smaller cells would not separate boxes better

/// The number of cells from `first` to `last`, which may differ by more than an int can hold.
std::uint32_t cellsFrom(std::int32_t first, std::int32_t last) {
    return static_cast<std::uint32_t>(last) - static_cast<std::uint32_t>(first) + 1;
}

/// A hierarchical grid: a few grids, each with cells four times as large as the one before. The best choice
/// where boxes have similar sizes and all move fast. A box is stored in the finest grid in which it spans at
/// most two cells along each axis, in the cell of its top-left corner. Each grid is wrapped to a torus with
/// about as many cells as it has boxes, so the world may have any size; distant boxes that share a cell are
/// distinguished by their bounds. Cells may have a spare slot; a box without a free slot in its cell is
/// stored after all cells. Source: C. Ericson, "Real-Time Collision Detection", 2005, 7.1.3 (hashed storage)
/// and 7.2 (hierarchical grids)
class HierarchicalGrid : public SortedRows<HierarchicalGrid> {
public:
    HierarchicalGrid() : SortedRows{4} {}

    // Interface for PartitionedBroadPhase.
    void sort(const Proxies& proxies, std::span<const std::uint32_t> order, std::uint32_t moving,
              const LocationList& list) {
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

    std::uint32_t move(const Proxies& proxies, std::uint32_t place) {
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

    void visitRegions(const std::function<void(const AABB&)>& visit) const {
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

    // Interface for SortedRows and RowBroadPhase.
    std::uint32_t freePlace(const AABB& box) { return placeIn(cellOf(box)); }
    [[nodiscard]] bool areNear(std::uint32_t a, std::uint32_t b) const {
        return b < sorted_ && cells_[a].level == cells_[b].level && cells_[a].y == cells_[b].y &&
               static_cast<std::uint32_t>(cells_[b].x) - static_cast<std::uint32_t>(cells_[a].x) <=
                   kNearCells;
    }
    template <class Visit>
    void visitNear(const AABB& box, const LineSweep* sweep, std::uint32_t from, const Visit& visit) const {
        for (const Level& level : levels_) {
            if (level.count > 0) visitLevel(level, box, sweep, from, visit);
        }
        if (places() > sorted_) visit(std::max(sorted_, from), places());
    }

private:
    static constexpr std::uint32_t kNearCells = 12;  // cells of a row whose boxes search together
    static constexpr std::uint32_t kLevels = 10;     // the last level is a single cell

    struct Cell {
        std::int32_t x = 0;
        std::int32_t y = 0;
        std::uint32_t level = 0;
        friend bool operator==(const Cell&, const Cell&) = default;
    };
    struct Level {
        float perMetre = 0.0f;      ///< cells per m
        std::uint32_t columns = 1;  ///< a power of two, like `rows`
        std::uint32_t rows = 1;
        std::uint32_t firstCell = 0;  ///< index in starts_
        std::uint32_t count = 0;      ///< number of boxes
    };

    /// The left, top, right and bottom side of a box in cells, rounded down and clamped to 2^30. The
    /// compiler's vectors handle all four at once.
    static std::array<std::int32_t, 4> cellsOf(const AABB& box, float perMetre) {
        using Four [[gnu::vector_size(16)]] = float;
        using Cells = decltype(Four{} < Four{});
        const Four most = 0x1p30f - Four{};
        Four sides = std::bit_cast<Four>(box) * perMetre;
        sides = sides < most ? sides : most;
        sides = sides > -most ? sides : -most;
        const Cells cells = __builtin_convertvector(sides, Cells);
        return std::bit_cast<std::array<std::int32_t, 4>>(
            cells + (sides < __builtin_convertvector(cells, Four)));  // true is -1
    }

    [[nodiscard]] Cell cellOf(const AABB& box) const {
        for (std::uint32_t level = 0; level + 1 < kLevels; ++level) {
            const auto sides = cellsOf(box, levels_[level].perMetre);
            if (cellsFrom(sides[0], sides[2]) <= 2 && cellsFrom(sides[1], sides[3]) <= 2)
                return {sides[0], sides[1], level};
        }
        return {0, 0, kLevels - 1};
    }

    [[nodiscard]] std::uint32_t indexOf(const Cell& cell) const {
        const Level& level = levels_[cell.level];
        const std::uint32_t column = static_cast<std::uint32_t>(cell.x) & (level.columns - 1);
        const std::uint32_t row = static_cast<std::uint32_t>(cell.y) & (level.rows - 1);
        return level.firstCell + row * level.columns + column;
    }

    /// Calls visit(begin, end) with ranges of slots: those of `wide` cells of a row from column `left` on.
    template <class Visit>
    void visitRow(const Level& level, std::int32_t row, std::int32_t left, std::uint32_t wide,
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
    void visitLevel(const Level& level, const AABB& box, const LineSweep* sweep, std::uint32_t from,
                    const Visit& visit) const {
        const std::uint32_t begin = starts_[level.firstCell];
        const std::uint32_t end = starts_[level.firstCell + level.columns * level.rows];
        if (end <= from) return;
        // A box spans at most two cells, so boxes of the next cell to the left or above may reach in.
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

    /// Returns the interval of x that the sweep covers while it may overlap boxes of a row.
    static Vec2 alongRow(const LineSweep& sweep, double top, double bottom) {
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

    /// Chooses cell sizes, if the boxes changed much or the last choice is old.
    void chooseSizes(const Proxies& proxies, std::span<const std::uint32_t> order) {
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

    /// Chooses a cell for each box, and creates about as many cells in each grid as it has boxes.
    void chooseCells(const Proxies& proxies, std::span<const std::uint32_t> order) {
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

    /// Returns a free slot in the cell, or else a new one after all cells.
    std::uint32_t placeIn(const Cell& cell) {
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

    Level levels_[kLevels];
    std::vector<std::uint32_t> starts_;  ///< first slot of each cell, then the end of the last cell
    std::vector<Cell> cells_;            ///< cell of each slot
    float aspect_ = 1.0f;  ///< ratio of the width to the height of the area that the boxes are spread over

    std::vector<AABB> orderBoxes_;  ///< bounds of the boxes, during the sort
    std::vector<Cell> orderCells_;
};

}  // namespace

std::unique_ptr<BroadPhase> makeGrid() { return std::make_unique<RowBroadPhase<HierarchicalGrid>>(); }

}  // namespace plumb::physics
