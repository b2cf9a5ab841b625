#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "physics/broadphase/broad_phase.hpp"
#include "physics/broadphase/line_sweep.hpp"
#include "physics/broadphase/overlap.hpp"

namespace plumb::physics {

/// A list of boxes in structure-of-arrays layout, to be compared with eight consecutive boxes at a time. The
/// right and bottom sides are negated, as in TreeBoxes. Free slots overlap nothing, nor do the eight slots of
/// padding at the end.
struct BoxRows {
    static constexpr std::uint8_t kFree = 0;
    static constexpr std::uint8_t kThere = 1;
    static constexpr std::uint8_t kAwake = 3;  ///< ProxyMotion::Awake

    std::array<std::vector<float>, 4> low;  ///< m: left, top, -right, -bottom
    std::vector<Filter> filters;
    std::vector<std::uint32_t> ids;
    std::vector<std::uint8_t> states;  ///< kFree, kThere or kAwake
    std::uint32_t count = 0;           ///< number of slots, including free ones
    std::uint32_t free = 0;
    std::uint32_t layers = 0;  ///< union over all proxies that were stored since reset(); see overruledBy()
    std::uint32_t masks = 0;

    BoxRows() { reset(0); }
    /// Clears the list and creates free slots.
    void reset(std::uint32_t places);
    /// Appends a free slot.
    std::uint32_t addPlace();
    /// Removes the last slot, which must be free.
    void dropPlace();
    /// @param box  the bounds after usable()
    void write(const Proxies& proxies, std::uint32_t place, std::uint32_t id, const AABB& box);
    void erase(std::uint32_t place);
    [[nodiscard]] std::uint32_t size() const { return count - free; }
    [[nodiscard]] bool isFree(std::uint32_t place) const { return states[place] == kFree; }
    /// False if no proxy in the list can pass this filter.
    [[nodiscard]] bool mayCollide(const Filter& filter) const {
        const std::uint32_t overruled = overruledBy(filter.group);
        return ((filter.layers | overruled) & masks) != 0 && ((filter.mask | overruled) & layers) != 0;
    }
    [[nodiscard]] AABB boxAt(std::uint32_t place) const {
        return {{low[0][place], low[1][place]}, {-low[2][place], -low[3][place]}};
    }
};

/// A range of slots.
struct Stretch {
    std::uint32_t begin;
    std::uint32_t end;
};

/// Proxies near each other that search for partners together.
struct RowSearch {
    static constexpr std::uint32_t kMaxLookers = 8;

    const BoxRows* own = nullptr;
    const BoxRows* others = nullptr;  ///< may be equal to `own`
    bool ownMayBeAwake = false;
    bool allCanPair = false;  ///< one side is the moving and the other the sleeping partition; otherwise one
                              ///< proxy of a pair must be awake
    bool onlyLater = false;  ///< every proxy of the list searches, so each only tests the slots after its own
    const std::uint8_t* isMoved = nullptr;    ///< by proxy: nonzero for all that search
    std::uint32_t lookers[kMaxLookers] = {};  ///< slots in `own`, ascending
    std::uint32_t count = 0;
};

/// The four sides of a box in cell coordinates of a grid.
using BoxCells = std::array<std::int32_t, 4>;

/// The searches through rows, compiled for one instruction set.
struct RowSearches {
    void (*findPairs)(const RowSearch& search, std::span<const Stretch> stretches,
                      std::vector<PairKey>& pairs);
    /// Appends the ids of the proxies in `part` that the box overlaps and, unless `sweep` is null, that the
    /// sweep may hit.
    void (*findInBox)(const BoxRows& rows, Stretch part, const AABB& box, const LineSweep* sweep,
                      std::uint32_t mask, std::vector<std::uint32_t>& found);
    /// For each box its left, top, right and bottom side in cells, rounded down and clamped to 2^30. The
    /// number of boxes must be even.
    void (*findCells)(std::span<const AABB> boxes, float perMetre, std::span<BoxCells> cells);
};

}  // namespace plumb::physics
