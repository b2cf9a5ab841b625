#pragma once

#include "core/cpu.hpp"
#include "physics/broadphase/box_rows.hpp"
#include "physics/broadphase/tree_search.hpp"

namespace plumb::physics {

/// What broad phases do with eight boxes at a time, as compiled for one kind of processor. Which one changes
/// nothing but the time.
struct BoxSearches {
    TreeSearches trees;
    RowSearches rows;
};

const BoxSearches& boxSearchesFor(SimdWidth width);

}  // namespace plumb::physics
