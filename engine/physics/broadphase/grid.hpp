#pragma once

#include "physics/broadphase/cell_grid.hpp"
#include "physics/broadphase/row_broad_phase.hpp"

namespace plumb::physics {

/// Uniform grids. Best where all are of about one size and all move fast.
using GridBroadPhase = RowBroadPhase<CellGrid>;

}  // namespace plumb::physics
