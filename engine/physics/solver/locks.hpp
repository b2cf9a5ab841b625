#pragma once

#include "physics/stages.hpp"

namespace plumb::physics {

// Bodies that do not move along x or y: after each pass the velocity along it is 0 again. Nothing happens
// where no body is locked.

void prepareLocks(StepContext& step);
/// @param velocity  by slot: x and y of each row
void lockAxes(const StepContext& step, const SolveGroup& group, std::vector<Float4>& velocity);

}  // namespace plumb::physics
