#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "physics/broadphase/overlap.hpp"

namespace plumb::physics {

/// Approximate statistics of the sizes and positions of boxes.
struct BoxStatistics {
    float extent = 0.0f;   ///< m: third quartile of the sizes, but at most twice their median
    float spacing = 0.0f;  ///< m: distance between neighbours, if the boxes were spread evenly
    float aspect = 1.0f;   ///< ratio of the width to the height of the area that they are spread over
};

[[nodiscard]] BoxStatistics statisticsOf(const Proxies& proxies, std::span<const std::uint32_t> ids);

/// A list of boxes in structure-of-arrays layout, so that a search tests eight consecutive boxes at once. It
/// is the common part of HierarchicalGrid and SweepAndPruneAxis. Right and bottom sides are negated, as in
/// TreeBoxes. Free slots overlap nothing, nor do the eight slots of padding at the end.
///
/// Boxes that were added since the last sort, or that moved too far from their sorted position, are stored
/// after the sorted ones, where every search tests all of them, until sorting again costs less than that.
class BoxRows {
public:
    static constexpr std::uint8_t kFree = 0;   ///< an empty slot
    static constexpr std::uint8_t kInUse = 1;  ///< a proxy that is not awake
    static constexpr std::uint8_t kAwake = 3;  ///< ProxyMotion::Awake

    std::array<std::vector<float>, 4> low;  ///< m: left, top, -right, -bottom
    std::vector<Filter> filters;            ///< per slot
    std::vector<std::uint32_t> ids;         ///< per slot: index of the proxy
    std::vector<std::uint8_t> states;       ///< per slot: kFree, kInUse or kAwake
    FilterUnion all;                        ///< filters of all proxies that were stored since reset()

    [[nodiscard]] AABB boxAt(std::uint32_t place) const {
        return {{low[0][place], low[1][place]}, {-low[2][place], -low[3][place]}};
    }

    // Interface for PartitionedBroadPhase.
    void erase(std::uint32_t place) {
        for (auto& side : low) side[place] = kEmpty;
        states[place] = kFree;
        ++free_;
    }
    void settle(std::size_t searches);
    [[nodiscard]] bool isDue(std::size_t arrivals, std::uint32_t moving) const {
        const std::size_t behind = count_ - sorted_ + arrivals;
        return mostMove(moving) || lost_ > kTestsPerSort * size() || behind > sorted_ / 2 + kFew ||
               size() < sortedSize_ / 4;
    }
    [[nodiscard]] std::uint32_t places() const { return count_; }
    [[nodiscard]] bool isFree(std::uint32_t place) const { return states[place] == kFree; }
    [[nodiscard]] std::uint32_t idAt(std::uint32_t place) const { return ids[place]; }
    [[nodiscard]] std::uint32_t size() const { return count_ - free_; }

protected:
    /// @param share  all boxes are sorted again in each step in which more than size() / share of them move
    explicit BoxRows(std::uint32_t share) : share_{share} { reset(0, 0); }

    /// Clears the list and creates `places` free slots for a sorted list of `boxes` boxes.
    void reset(std::uint32_t places, std::size_t boxes);
    std::uint32_t addPlace() {
        resize(count_ + 1);
        return count_ - 1;
    }
    /// @param box  the bounds after usable()
    void write(const Proxies& proxies, std::uint32_t place, std::uint32_t id, const AABB& box);
    /// True if so many boxes move that they will be sorted in each step.
    [[nodiscard]] bool mostMove(std::uint32_t moving) const {
        return moving > size() / share_ && size() > kFew;
    }
    /// Returns statistics for a new choice of the sort parameters if the number of boxes differs much from
    /// that at the last choice, or the last choice is old; else nothing.
    std::optional<BoxStatistics> newStatistics(const Proxies& proxies, std::span<const std::uint32_t> order);

    std::uint32_t sorted_ = 0;  ///< slots that are sorted

private:
    static constexpr std::uint32_t kFew = 32;          ///< so few boxes are not worth sorting
    static constexpr std::uint64_t kTestsPerSort = 8;  ///< cost of sorting one box, in tests of eight boxes
    static constexpr float kEmpty = std::numeric_limits<float>::infinity();

    void resize(std::uint32_t places);

    std::uint32_t share_;
    std::uint32_t count_ = 0;  ///< number of slots, including free ones
    std::uint32_t free_ = 0;
    std::uint32_t sortedSize_ = 0;  ///< number of boxes at the last sort
    std::uint64_t lost_ = 0;        ///< number of tests of unsorted boxes since the last sort
    std::size_t chosenFor_ = 0;     ///< number of boxes at the last choice of the sort parameters
    std::uint32_t sortsSince_ = 0;  ///< sorts since that choice
};

struct SlotRange {  // the slots begin to end - 1
    std::uint32_t begin;
    std::uint32_t end;
};

}  // namespace plumb::physics
