#pragma once

#include "physics/broadphase/row_broad_phase.hpp"
#include "physics/broadphase/sorted_rows.hpp"

namespace plumb::physics {

/// Sorted along one axis. Best where all move fast along a line.
using SweepAndPruneBroadPhase = RowBroadPhase<SortedRows>;

}  // namespace plumb::physics
