#pragma once

#include <vector>

#include "physics/solver/n_body_constraint.hpp"
#include "physics/trees/joint_trees.hpp"

namespace plumb::physics {

/// Blocks of one kind and the joints in them.
template <class Block>
struct JointStore {
    std::vector<Block> blocks;
    std::vector<JointLanes> lanes;
    std::vector<std::uint8_t> groups;  ///< by block
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

/// A further JointFlag: the definition was changed, and the joint has not yet closed since. A change may do
/// work, as a rope that is shortened does.
inline constexpr std::uint8_t kDefinitionChanged = 128;

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
