#pragma once

#include "physics/broadphase/row_broad_phase.hpp"
#include "physics/broadphase/sorted_rows.hpp"

namespace plumb::physics {

/// Sorted along one axis. Best in small worlds, and in long narrow ones.
using SweepAndPruneBroadPhase = RowBroadPhase<SortedRows>;

}  // namespace plumb::physics
