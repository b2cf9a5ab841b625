#pragma once

#include <vector>

#include "physics/joints/joint_types.hpp"
#include "physics/trees/joint_trees.hpp"

namespace plumb::physics {

/// Blocks of one kind and the joints in them.
template <class Block>
struct JointStore {
    std::vector<Block> blocks;
    std::vector<BlockLanes> lanes;
    std::vector<std::uint8_t> groups;  ///< by block
};

/// A joint that can break, and its location in the blocks.
struct BreakableJoint {
    std::uint32_t joint;
    std::int32_t kind;  ///< JointBlockKind, or kInTree
    std::int32_t block;
    std::int32_t lane;
    float force = 0.0f;   ///< N: maximum of all substeps
    float torque = 0.0f;  ///< N m
};

/// Joint data of a step, in Workspace.
struct JointWork {
    JointStore<PointBlock> points;
    JointStore<HingeBlock> hinges;
    JointStore<RodBlock> rods;
    JointStore<SliderBlock> sliders;
    std::vector<NBodyConstraint> nBodyConstraints;
    JointTrees trees;
    std::vector<std::int32_t> counts;  ///< number of joints by group, color and kind
    std::vector<std::int32_t> keys;    ///< indexed like Joints::awake: see keyOf() in joint_lanes.cpp
    std::vector<BreakableJoint> breakables;
};

}  // namespace plumb::physics
