#pragma once

#include "physics/trees/joint_trees.hpp"

namespace plumb::physics {

constexpr int rowsOf(TreeJointKind kind) {
    return kind == TreeJointKind::Rod ? 1 : kind == TreeJointKind::Weld ? 3 : 2;
}

/// True if a limb has a link: all but the root of a floating tree.
inline bool hasLink(const JointTree& tree, std::int32_t treeBody) {
    return tree.rooted || treeBody + 1 < tree.end;
}

/// Calls act(link) for all joints of a tree.
template <class Act>
void forLinks(JointTrees& trees, const JointTree& tree, Act&& act) {
    for (std::int32_t i = tree.begin; i < tree.end; ++i) {
        if (hasLink(tree, i)) act(trees.links[static_cast<std::size_t>(i)]);
    }
    for (std::int32_t n = tree.holdBegin; n < tree.holdEnd; ++n)
        act(trees.holds[static_cast<std::size_t>(n)]);
}

/// A pose, rotated further by an angle (rad).
TreePose turnedBy(const TreePose& pose, double angle);

/// Computes the arms or rows of a link at two poses.
/// @return gaps of its rows: m or rad
Triple setRows(Link& link, const TreePose& treeBody, const TreePose& parent);
Triple gapsOf(const Link& link, const TreePose& treeBody, const TreePose& parent);

}  // namespace plumb::physics
