#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "physics/broadphase/box_rows.hpp"

namespace plumb::physics {

/// Rows that were sorted at some time: the common part of HierarchicalGrid and SweepAndPruneAxis. Boxes that
/// were added since, or that moved too far from where they were sorted to, are stored after the sorted ones,
/// where every search tests them all, until sorting again costs less than these tests.
class OrderedRows {
public:
    // Interface for ProxyPartitions.
    void erase(std::uint32_t place) { rows_.erase(place); }
    void settle(std::size_t searches);
    [[nodiscard]] bool isDue(std::size_t arrivals) const;
    [[nodiscard]] std::uint32_t places() const { return rows_.count; }
    [[nodiscard]] std::uint32_t size() const { return rows_.size(); }
    [[nodiscard]] std::uint32_t idAt(std::uint32_t place) const { return rows_.ids[place]; }

    [[nodiscard]] const BoxRows& rows() const { return rows_; }

protected:
    static constexpr std::uint32_t kFew = 32;  ///< this many boxes need no order

    void clearRows();
    /// Fills order_ with the ids of all stored boxes and `arrivals`.
    void collect(std::span<const std::uint32_t> arrivals);
    /// The boxes of order_ occupy the first `places` slots now.
    void noteSorted(std::uint32_t places);
    /// True if the number of boxes in order_ differs much from that at the last choice, or the last choice is
    /// old: the parameters of the order have to be chosen again.
    bool choiceIsDue();

    BoxRows rows_;
    std::uint32_t sorted_ = 0;          ///< slots that are sorted
    std::vector<std::uint32_t> order_;  ///< ids, while they are sorted

private:
    std::uint32_t sortedSize_ = 0;  ///< number of boxes at the last sort
    std::uint64_t lost_ = 0;        ///< tests that searches have made among the unsorted boxes since then
    std::size_t chosenFor_ = 0;     ///< number of boxes at the last choice
    std::uint32_t sortsSince_ = 0;
};

}  // namespace plumb::physics
