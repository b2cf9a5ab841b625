#pragma once

#include "physics/solver/joint_lanes.hpp"

namespace plumb::physics {

/// Adds a joint to the ties of the step.
void addTie(StepContext& step, std::uint32_t joint, std::uint8_t group);
/// One pass over the ties of a group, in order.
void solveTies(Workspace& work, const JointPass& pass, const SolveGroup& group, JointAct act);
/// Forces and errors back to the joints.
void storeTies(StepContext& step);

}  // namespace plumb::physics
