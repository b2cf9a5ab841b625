#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "physics/broadphase/box_rows.hpp"

namespace plumb::physics {

/// Rows that were put in some order. Who came later, or strayed from its place, is behind those, where every
/// search looks, until putting everybody in order anew costs less. What a CellGrid and SortedRows have in
/// common.
class OrderedRows {
public:
    // What PartedProxies asks of a part.
    void erase(std::uint32_t place) { rows_.erase(place); }
    void settle(std::size_t searches);
    [[nodiscard]] bool isDue(std::size_t arrivals) const;
    [[nodiscard]] std::uint32_t places() const { return rows_.count; }
    [[nodiscard]] std::uint32_t size() const { return rows_.size(); }
    [[nodiscard]] std::uint32_t idAt(std::uint32_t place) const { return rows_.ids[place]; }

    [[nodiscard]] const BoxRows& rows() const { return rows_; }

protected:
    static constexpr std::uint32_t kFew = 32;  ///< are searched without an order

    void clearRows();
    /// Fills order_ with those who are here, and arrivals.
    void collect(std::span<const std::uint32_t> arrivals);
    /// Those in order_ are on the first places now.
    void noteSorted(std::uint32_t places);
    /// Whether those in order_ are others than when this last said so, or that is long ago: how they are put
    /// in order has to be chosen anew.
    bool choiceIsDue();

    BoxRows rows_;
    std::uint32_t sorted_ = 0;          ///< places that are in order
    std::vector<std::uint32_t> order_;  ///< ids, while they are put in order

private:
    std::uint32_t sortedSize_ = 0;  ///< boxes that were put in order
    std::uint64_t lost_ = 0;        ///< tests that searches have made behind them
    std::size_t chosenFor_ = 0;     ///< boxes, at the last choice
    std::uint32_t sortsSince_ = 0;
};

}  // namespace plumb::physics
