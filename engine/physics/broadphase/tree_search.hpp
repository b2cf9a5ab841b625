#pragma once

#include <cstdint>
#include <vector>

#include "physics/broadphase/line_sweep.hpp"
#include "physics/broadphase/packed_tree.hpp"

namespace plumb::physics {

/// Some lanes of one leaf look for partners in a tree.
struct TreeSearch {
    const PackedTree* own = nullptr;
    const PackedTree* others = nullptr;  ///< may be the same; not empty
    std::uint32_t leaf = 0;              ///< of `own`
    std::uint32_t lanes = 0;             ///< bits: those of it that look
    bool ownMayBeAwake = false;
    bool allCanPair = false;                ///< the moving and the sleeping; else one has to be awake
    const std::uint8_t* isMoved = nullptr;  ///< by proxy: nonzero for all that look
};

/// The searches through trees as compiled for one kind of processor. Trees are not empty.
struct TreeSearches {
    void (*findPairs)(const TreeSearch& search, std::vector<PairKey>& pairs);
    void (*findInBox)(const PackedTree& tree, const AABB& box, std::uint32_t mask,
                      std::vector<std::uint32_t>& found);
    void (*findOnSweep)(const PackedTree& tree, const LineSweep& sweep, std::uint32_t mask,
                        std::vector<std::uint32_t>& found);
};

}  // namespace plumb::physics
