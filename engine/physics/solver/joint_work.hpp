#pragma once

#include <vector>

#include "physics/solver/joint_block.hpp"
#include "physics/trees/joint_trees.hpp"

namespace plumb::physics {

/// Blocks of one kind and the joints in them.
template <class Block>
struct JointStore {
    std::vector<Block> blocks;
    std::vector<BlockLanes> lanes;
    std::vector<std::uint8_t> groups;  ///< by block
};

/// Jacobian of a multi-body constraint with respect to one body.
struct NBodyJacobian {
    std::uint32_t body = 0;
    float x = 0.0f;
    float y = 0.0f;
    float turn = 0.0f;
};

/// Constraint that keeps a sum over up to four bodies at 0: gears and pulleys. They are rare, so they are
/// solved one by one. Jacobians are those of the start of the step.
struct NBodyConstraint {
    NBodyJacobian ends[4];
    std::int32_t count = 0;     ///< of ends
    std::int32_t reported = 0;  ///< the end whose force jointForce() reports
    float error = 0.0f;         ///< at the start of the step
    std::int32_t slots[4] = {};
    float inverseInertia[4] = {};
    float mass = 0.0f;
    float impulse = 0.0f;
    std::uint32_t joint = 0;
    std::uint8_t group = 0;

    void add(const NBodyJacobian& end) { ends[count++] = end; }
};

/// A joint that can break, and where it is solved.
struct BreakableJoint {
    std::uint32_t joint;
    std::int32_t kind;
    std::int32_t block;
    std::int32_t lane;
    float force = 0.0f;   ///< N: largest of all substeps
    float torque = 0.0f;  ///< N m
};

/// A further JointFlag: the joint has not closed since it was created open, its definition was changed or one
/// of its bodies was put elsewhere. To close it may do work, as a rope that is shortened does.
inline constexpr std::uint8_t kEdited = 128;

/// Joint data of a step, in Workspace.
struct JointWork {
    JointStore<PointBlock> points;
    JointStore<HingeBlock> hinges;
    JointStore<RodBlock> rods;
    JointStore<SliderBlock> sliders;
    std::vector<NBodyConstraint> nBodyConstraints;
    JointTrees trees;
    std::vector<std::int32_t> counts;  ///< by group, color and kind
    std::vector<std::int32_t> keys;    ///< by index in Joints::awake
    std::vector<BreakableJoint> breakables;
};

}  // namespace plumb::physics
