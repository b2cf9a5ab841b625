#pragma once

#include "physics/stages.hpp"

namespace plumb::physics {

// Rolling resistance: a torque between two bodies against their turning on each other, at most so many metres
// times the force that presses them together. Nothing happens where no shape resists rolling.

void prepareRolling(StepContext& step);
void warmStartRolling(StepContext& step, const SolveGroup& group);
/// After the contacts' relax pass of a substep.
void relaxRolling(StepContext& step, const SolveGroup& group);
void storeRolling(StepContext& step);

}  // namespace plumb::physics
