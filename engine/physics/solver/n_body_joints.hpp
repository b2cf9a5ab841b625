#pragma once

#include "physics/solver/joint_lanes.hpp"

namespace plumb::physics {

/// Adds a gear or pulley to the multi-body constraints of the step.
void addTie(StepContext& step, std::uint32_t joint, std::uint8_t group);
/// One pass over the multi-body constraints of a group, in order.
void solveTies(Workspace& work, const JointPass& pass, const SolveGroup& group, PassKind kind);
/// Writes forces and errors back to the joints.
void storeTies(StepContext& step);

}  // namespace plumb::physics
