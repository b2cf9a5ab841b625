#pragma once

#include "physics/broadphase/hierarchical_grid.hpp"
#include "physics/broadphase/row_broad_phase.hpp"

namespace plumb::physics {

/// Uniform grids. The best choice where boxes have similar sizes and all move fast.
using GridBroadPhase = RowBroadPhase<HierarchicalGrid>;

}  // namespace plumb::physics
