#pragma once

#include "physics/stages.hpp"

namespace plumb::physics {

/// BounceBlock::sum of a contact that does not propagate impacts.
inline constexpr float kNoChain = -1.0f;

/// Propagation of simultaneous impacts: a ball that hits a row of balls which touch without load ejects the
/// last one. The substeps stop all balls at once and share out the momentum, so their impulses are taken
/// back, and the pairs collide sequentially until none approaches. Only for round contacts that bounce:
/// bodies that rest on two points, or under a load, do not transmit an impact as a whole. Source: B. Smith et
/// al., "Reflections on Simultaneous Impact", SIGGRAPH 2012, section 3, on what a sequence of pairwise
/// impacts gets right.
void runImpactsOn(StepContext& step, const SolveGroup& group);

}  // namespace plumb::physics
