#pragma once

#include "core/cpu.hpp"
#include "physics/broadphase/box_rows.hpp"
#include "physics/broadphase/tree_search.hpp"

namespace plumb::physics {

/// The functions of the broad phases that handle eight boxes at a time, compiled for one instruction set. The
/// choice affects the time only.
struct BoxSearches {
    TreeSearches trees;
    RowSearches rows;
};

const BoxSearches& boxSearchesFor(SimdWidth width);

}  // namespace plumb::physics
