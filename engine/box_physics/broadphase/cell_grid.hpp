#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "math/rect.hpp"

namespace plumb::box_physics {

/// One body in one cell that its bounds reach.
struct CellEntry {
    std::uint32_t body = 0;
    std::int32_t x = 0;  ///< cell
    std::int32_t y = 0;
    AABB bounds;  ///< a copy: what lies in one cell is compared without looking elsewhere
};

/// A uniform grid over the whole plane in flat arrays: cells far apart share a slot of the table, which costs
/// a comparison and never a wrong result. Built at once by counting, so its order is that of the bodies.
class CellGrid {
public:
    static constexpr int kMaxCellsPerBody = 4096;

    struct Cells {
        std::int32_t minX = 0, minY = 0, maxX = 0, maxY = 0;
        [[nodiscard]] std::int64_t count() const {
            return (std::int64_t{maxX} - minX + 1) * (std::int64_t{maxY} - minY + 1);
        }
    };

    /// Fills the grid with these bodies. Those that reach more than `most` cells go to `tooLarge`.
    void build(std::span<const std::uint32_t> bodies, std::span<const AABB> bounds, float cellSize, int most,
               std::vector<std::uint32_t>& tooLarge);

    [[nodiscard]] bool empty() const { return entries_.empty(); }
    [[nodiscard]] float cellSize() const { return size_; }
    [[nodiscard]] Cells cellsOf(const AABB& bounds) const {
        return {cellAt(bounds.min.x), cellAt(bounds.min.y), cellAt(bounds.max.x), cellAt(bounds.max.y)};
    }
    /// Entries of the slot that holds this cell; some may be of other cells.
    [[nodiscard]] std::span<const CellEntry> slotOf(std::int32_t x, std::int32_t y) const {
        const std::size_t slot = slotIndex(x, y);
        return {entries_.data() + starts_[slot], starts_[slot + 1] - starts_[slot]};
    }
    [[nodiscard]] std::size_t slotCount() const { return starts_.empty() ? 0 : starts_.size() - 2; }
    [[nodiscard]] std::span<const CellEntry> slot(std::size_t index) const {
        return {entries_.data() + starts_[index], starts_[index + 1] - starts_[index]};
    }
    /// True when the first cell that both bounds reach is this one: so a pair is found exactly once.
    [[nodiscard]] bool isFirstShared(const AABB& a, const AABB& b, std::int32_t x, std::int32_t y) const {
        return cellAt(std::max(a.min.x, b.min.x)) == x && cellAt(std::max(a.min.y, b.min.y)) == y;
    }

private:
    /// The cell that a coordinate lies in. std::floor is a call on plain x86-64.
    [[nodiscard]] std::int32_t cellAt(float coordinate) const {
        constexpr float kMost = 1073741824.0f;
        const float cell = std::min(std::max(coordinate * perSize_, -kMost), kMost);
        const auto cut = static_cast<std::int32_t>(cell);
        return cut - (static_cast<float>(cut) > cell ? 1 : 0);
    }
    [[nodiscard]] std::size_t slotIndex(std::int32_t x, std::int32_t y) const {
        return (static_cast<std::uint32_t>(x) & widthMask_) |
               static_cast<std::size_t>(static_cast<std::uint32_t>(y) & heightMask_) << widthBits_;
    }

    float size_ = 1.0f;
    float perSize_ = 1.0f;
    std::uint32_t widthMask_ = 0;
    std::uint32_t heightMask_ = 0;
    unsigned widthBits_ = 0;
    struct Reached {
        std::uint32_t body = 0;
        std::int32_t x = 0;  ///< cell
        std::int32_t y = 0;
    };

    std::vector<std::uint32_t> starts_;  ///< in entries_, of every slot; then their end; one more to count
    std::vector<CellEntry> entries_;
    std::vector<Reached> unsorted_;
};

/// A cell about twice as wide as the usual body, a power of two so that cells are cut the same everywhere.
float cellSizeFor(std::span<const std::uint32_t> bodies, std::span<const AABB> bounds);

}  // namespace plumb::box_physics
