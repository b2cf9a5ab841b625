#pragma once

#include "physics/edits.hpp"
#include "physics/stages.hpp"

namespace plumb::physics {

/// Value of BreakableJoint::kind for a joint in a tree.
inline constexpr std::int32_t kInTree = kJointBlockKinds + 1;

/// Calls act(store, kind) for each kind of blocks.
template <class Act>
void forKinds(JointWork& joints, Act&& act) {
    act(joints.points, kPointBlocks);
    act(joints.hinges, kHingeBlocks);
    act(joints.rods, kRodBlocks);
    act(joints.sliders, kSliderBlocks);
}

inline constexpr int kJointGrain = 24;  ///< blocks per piece of work

/// Returns the substep rate (1/s) of a group.
inline float rateOf(const StepContext& step, std::uint8_t group) {
    return static_cast<float>(step.work.groups[group].substeps) / step.dt;
}

/// Calls act(block, lanes, rate) for all blocks, distributed over threads.
template <class Act>
void forJointBlocks(StepContext& step, Act&& act) {
    forKinds(step.work.joints, [&](auto& store, JointBlockKind) {
        forEach(step.pool, store.blocks.size(), kJointGrain,
                [&](std::size_t n) { act(store.blocks[n], store.lanes[n], rateOf(step, store.groups[n])); });
    });
}

/// Packs awake joints into blocks. Called after gatherBodies.
void prepareJoints(StepContext& step);

/// Returns the parameters of joints for a substep of h seconds.
inline JointPass jointPass(const Settings& settings, float h) {
    const Softness soft = softness(settings.jointStiffness / h, settings.jointDampingRatio, h);
    return {gripOf(soft), 1.0f / h, kJointPushing * settings.pushSpeed};
}
/// Performs one pass over the joints of one color of a group.
void solveJoints(const StepContext& step, const SolverBodies& bodies, const JointPass& pass,
                 const SolveGroup& group, int colour, PassKind kind);

// joint_forces.cpp

/// Records the largest forces on breakable joints. Called after each substep.
void noteJointForces(StepContext& step, const SolveGroup& group, float substepRate);

/// Stores forces in World::joints.
void storeJoints(StepContext& step);

// n_body_joints.cpp

/// Adds a gear or pulley to JointWork::nBodyConstraints.
void addTie(StepContext& step, std::uint32_t joint, std::uint8_t group);
/// Performs one pass over the gears and pulleys of a group, sequentially.
void solveTies(Workspace& work, const JointPass& pass, const SolveGroup& group, PassKind kind);
/// Stores forces and errors of gears and pulleys in World::joints.
void storeTies(StepContext& step);

}  // namespace plumb::physics
