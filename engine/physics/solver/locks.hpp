#pragma once

#include "physics/stages.hpp"

namespace plumb::physics {

// Bodies locked along x or y: after each pass their velocity along it is set to 0 again. Costs nothing if no
// body is locked.

void prepareLocks(StepContext& step);
/// @param velocity  by slot: x and y of each row
void lockAxes(const StepContext& step, const SolveGroup& group, std::vector<Float4>& velocity);

}  // namespace plumb::physics
