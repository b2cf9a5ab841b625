#pragma once

#include "physics/stages.hpp"

namespace plumb::physics {

/// BounceBlock::sum of a contact that no impact runs on through.
inline constexpr float kNoChain = -1.0f;

/// Impacts that run on: a ball that hits a row of balls which touch, but do not press each other, throws off
/// the last one. The substeps stop all at once and share out the momentum, so what they did is taken back,
/// and the impacts happen one after the other, until nobody approaches. Only of round contacts that bounce:
/// what rests on two points, or under a load, does not pass a blow on as a whole. Source: B. Smith et al.,
/// "Reflections on Simultaneous Impact", SIGGRAPH 2012, section 3, on what a sequence of pairs gets right.
void runImpactsOn(StepContext& step, const SolveGroup& group);

}  // namespace plumb::physics
