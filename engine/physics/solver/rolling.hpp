#pragma once

#include "physics/stages.hpp"

namespace plumb::physics {

// Rolling resistance: a torque against the relative rotation of two bodies, at most the resistance (m) times
// the normal force. Costs nothing if no shape has it.

void prepareRolling(StepContext& step);
void warmStartRolling(StepContext& step, const SolveGroup& group);
/// After the contacts' relax pass of a substep.
void relaxRolling(StepContext& step, const SolveGroup& group);
void storeRolling(StepContext& step);

}  // namespace plumb::physics
