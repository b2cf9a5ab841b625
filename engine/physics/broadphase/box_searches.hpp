#pragma once

#include "core/cpu.hpp"
#include "physics/broadphase/box_rows.hpp"
#include "physics/broadphase/bvh8.hpp"

namespace plumb::physics {

/// Proxies of one partition that search for partners in another.
template <class Part>
struct PartSearch {
    const Part* own = nullptr;
    const Part* others = nullptr;           ///< may be equal to `own`; not empty
    bool ownMayBeAwake = false;             ///< `own` is the moving partition
    bool allCanPair = false;                ///< true: all pairs count; false: only pairs with an awake proxy
    const std::uint8_t* isMoved = nullptr;  ///< per proxy: nonzero if it searches
};

/// Some proxies of one leaf that search together.
struct TreeSearch : PartSearch<Bvh8> {
    std::uint32_t leaf = 0;   ///< index of the leaf in `own`
    std::uint32_t lanes = 0;  ///< bits: lanes of this leaf that search
};

/// Proxies near each other that search together.
struct RowSearch : PartSearch<BoxRows> {
    static constexpr std::uint32_t kMaxLookers = 8;

    bool onlyLater = false;  ///< every proxy of the list searches, so each only tests the slots after its own
    std::uint32_t searchers[kMaxLookers] = {};  ///< slots in `own` that search, ascending
    std::uint32_t count = 0;                    ///< number of searchers
};

/// The functions of the broad phases that handle eight boxes at a time, compiled for one instruction set. The
/// choice affects the time only, not the results. Trees must not be empty.
struct BoxSearches {
    void (*findPairsOfLeaf)(const TreeSearch& search, std::vector<PairKey>& pairs);
    void (*findPairsInRows)(const RowSearch& search, std::span<const SlotRange> ranges,
                            std::vector<PairKey>& pairs);
    /// Appends the ids of the proxies that the box overlaps and, unless `sweep` is null, the sweep may hit.
    /// @param box  the bounds of `sweep`, if there is one
    void (*findInTree)(const Bvh8& tree, const AABB& box, const LineSweep* sweep, std::uint32_t mask,
                       std::vector<std::uint32_t>& found);
    void (*findInRows)(const BoxRows& rows, SlotRange part, const AABB& box, const LineSweep* sweep,
                       std::uint32_t mask, std::vector<std::uint32_t>& found);
};

const BoxSearches& boxSearchesFor(SimdWidth width);

}  // namespace plumb::physics
