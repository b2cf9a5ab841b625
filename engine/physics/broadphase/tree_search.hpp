#pragma once

#include <cstdint>
#include <vector>

#include "physics/broadphase/bvh8.hpp"
#include "physics/broadphase/line_sweep.hpp"

namespace plumb::physics {

/// Some proxies of one leaf that search for partners in a tree.
struct TreeSearch {
    const Bvh8* own = nullptr;
    const Bvh8* others = nullptr;  ///< may be equal to `own`; not empty
    std::uint32_t leaf = 0;        ///< leaf of `own`
    std::uint32_t lanes = 0;       ///< bits: its lanes that search
    bool ownMayBeAwake = false;
    bool allCanPair = false;  ///< one side is the moving and the other the sleeping partition; otherwise one
                              ///< proxy of a pair must be awake
    const std::uint8_t* isMoved = nullptr;  ///< by proxy: nonzero for all that search
};

/// The searches through trees, compiled for one instruction set. The trees must not be empty.
struct TreeSearches {
    void (*findPairs)(const TreeSearch& search, std::vector<PairKey>& pairs);
    void (*findInBox)(const Bvh8& tree, const AABB& box, std::uint32_t mask,
                      std::vector<std::uint32_t>& found);
    void (*findOnSweep)(const Bvh8& tree, const LineSweep& sweep, std::uint32_t mask,
                        std::vector<std::uint32_t>& found);
};

}  // namespace plumb::physics
