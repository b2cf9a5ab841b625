#pragma once

#include "physics/stages.hpp"

namespace plumb::physics {

// Direct solver for joints that form trees (chains, pendulums, bridges): in each substep it solves all joints
// of a tree at once, in linear time. The system of masses and joints is factored (block L D L^T) from the
// leaves to the root, without fill-in. So joints hold for any chain length and load. Motors and limits are
// rows of the same system (Drive), so motors hold their speed within their force under any load. The SIMD
// solver handles springs, trees with contacts and trees with loops of dynamic bodies
// (joint_tree_builder.cpp). Source: D. Baraff, "Linear-Time Dynamics using Lagrange Multipliers", SIGGRAPH
// 1996. The biased pass closes gaps at the predicted poses, and the relax pass makes velocities consistent
// there: H. Andersen, "RATTLE", Journal of Computational Physics 52, 1983, which neither gains nor loses
// energy.

// joint_tree_builder.cpp

/// Determines which awake joints are solved directly and in which order: builds trees of bodies, from static
/// or kinematic bodies outwards. Depends on the joints alone, so a restored world has equal trees.
void growTrees(World& world, Workspace& work);

/// True if at least one tree is solved directly in this step.
inline bool solvesTrees(const World& world, const Workspace& work) {
    return work.joints.trees.some && world.manifest.runs(Effect::Joints);
}
/// True if all constraints of a body are joints that are solved directly in this step.
inline bool isInTree(const World& world, const Workspace& work, std::uint32_t body) {
    return solvesTrees(world, work) && work.colourMasks[body] != 0 &&
           work.colourMasks[body] == work.joints.trees.freeMasks[body];
}

// joint_tree_solver.cpp

/// Computes masses, arms and gaps at the start of the step. Called after gatherBodies.
void prepareTrees(StepContext& step);

/// Biased pass: computes velocities that close all gaps within a substep of h seconds. Relax pass, after the
/// bodies have moved: computes velocities that open no gap.
/// @param substep  index of the substep in the step
/// @param again  true for a further iteration in the same substep, after other constraints changed velocities
void solveTrees(StepContext& step, const SolveGroup& group, PassKind kind, float h, int substep, bool again);

/// Force (N) and torque (N m) of a joint on body B in the last substep.
struct JointForce {
    Vec2 force;
    float torque = 0.0f;
};
JointForce forceOf(const Link& link);
void storeTrees(StepContext& step);  ///< stores the forces of the joints in World::joints

}  // namespace plumb::physics
