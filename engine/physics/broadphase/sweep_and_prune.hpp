#pragma once

#include "physics/broadphase/row_broad_phase.hpp"
#include "physics/broadphase/sweep_and_prune_axis.hpp"

namespace plumb::physics {

/// Sweep and prune along one axis. The best choice where all bodies move fast along a line.
using SweepAndPruneBroadPhase = RowBroadPhase<SweepAndPruneAxis>;

}  // namespace plumb::physics
