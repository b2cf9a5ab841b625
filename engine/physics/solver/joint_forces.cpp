#include <algorithm>

#include "physics/solver/joint_lanes.hpp"
#include "physics/trees/joint_tree_solver.hpp"

namespace plumb::physics {

namespace {

float totalOf(const RowLanes& rows, int i) {
    return rows.holdImpulse[i] + rows.motorImpulse[i] + (rows.lowerImpulse[i] - rows.upperImpulse[i]);
}

/// Returns the rotation of a body since the start of the step.
/// @param offset  bytes: offset of the body's state, as in JointBodies
Rot turnOf(const StepContext& step, std::uint32_t offset) {
    const Float4& deltaPosition = step.work.deltaPosition[offset / sizeof(Float4)];
    return {1.0f + deltaPosition.w, deltaPosition.z};
}

/// Returns the torque (N m) about B's anchor of a force at the point by which balance() replaces it.
template <class Block>
float momentOf(const StepContext& step, const Joint& joint, const Block& block, int i, Vec2 force) {
    const Vec2 shift =
        block.anchors.armB.at(i) - rotate(step.world.bodies.pose[joint.bodyB].rotation, joint.anchorB);
    return cross(rotate(turnOf(step, block.bodies.b[i]), shift), force);
}

JointForce givenBy(const StepContext&, const Joint&, const PointBlock& block, int i, float rate) {
    return {block.impulse.at(i) * rate, 0.0f};
}
JointForce givenBy(const StepContext& step, const Joint& joint, const HingeBlock& block, int i, float rate) {
    const Vec2 force = givenBy(step, joint, static_cast<const PointBlock&>(block), i, rate).force;
    return {force, totalOf(block.turning, i) * rate + momentOf(step, joint, block, i, force)};
}
JointForce givenBy(const StepContext& step, const Joint&, const RodBlock& block, int i, float rate) {
    const auto arm = [&](const VecLanes& arms, const std::uint32_t* offset) {
        const Float4& moved = step.work.deltaPosition[offset[i] / sizeof(Float4)];
        return Vec2{moved.x, moved.y} + rotate(turnOf(step, offset[i]), arms.at(i)) - arms.at(i);
    };
    const Vec2 apart = block.anchors.apart.at(i) +
                       (arm(block.anchors.armB, block.bodies.b) - arm(block.anchors.armA, block.bodies.a));
    return {totalOf(block.along, i) * rate * normalized(apart), 0.0f};
}
JointForce givenBy(const StepContext& step, const Joint& joint, const SliderBlock& block, int i, float rate) {
    const Vec2 axis = rotate(turnOf(step, block.bodies.a[i]), block.axis.at(i));
    const Vec2 force = rate * (totalOf(block.along, i) * axis + block.acrossImpulse[i] * perpendicular(axis));
    return {force,
            rate * (block.angleImpulse[i] + block.spinImpulse[i]) + momentOf(step, joint, block, i, force)};
}

void storeRows(const RowLanes& rows, int i, float rate, Joint& joint) {
    joint.rows[0] = rows.holdImpulse[i] * rate;
    joint.rows[1] = rows.motorImpulse[i] * rate;
    joint.rows[2] = rows.lowerImpulse[i] * rate;
    joint.rows[3] = rows.upperImpulse[i] * rate;
}
void storeLane(const PointBlock&, int, float, Joint&) {}
void storeLane(const HingeBlock& block, int i, float rate, Joint& joint) {
    storeRows(block.turning, i, rate, joint);
    joint.rows[0] += joint.torque - totalOf(block.turning, i) * rate;
}
void storeLane(const RodBlock& block, int i, float rate, Joint& joint) {
    storeRows(block.along, i, rate, joint);
}
void storeLane(const SliderBlock& block, int i, float rate, Joint& joint) {
    storeRows(block.along, i, rate, joint);
    joint.rows[4] = block.acrossImpulse[i] * rate;
    joint.rows[5] = joint.torque;
}

void note(const JointForce& given, BreakableJoint& breakable) {
    breakable.force = std::max(breakable.force, length(given.force));
    breakable.torque = std::max(breakable.torque, std::fabs(given.torque));
}

void noteInTree(StepContext& step, const SolveGroup& group, BreakableJoint& breakable) {
    const JointTrees& trees = step.work.joints.trees;
    const auto place = static_cast<std::size_t>(breakable.block);
    const Link& link =
        place < trees.links.size() ? trees.links[place] : trees.holds[place - trees.links.size()];
    const std::int32_t slot = trees.treeBodies[link.treeBody].slot;
    if (slot >= group.begin && slot < group.end) note(forceOf(link), breakable);
}

}  // namespace

void noteJointForces(StepContext& step, const SolveGroup& group, float substepRate) {
    if (!step.world.manifest.runs(Effect::Joints)) return;  // then breakables is from an earlier step
    JointWork& joints = step.work.joints;
    for (BreakableJoint& breakable : joints.breakables) {
        if (breakable.kind == kInTree) noteInTree(step, group, breakable);
        forKinds(joints, [&](auto& store, JointBlockKind kind) {
            const auto block = static_cast<std::size_t>(breakable.block);
            if (breakable.kind != kind || &step.work.groups[store.groups[block]] != &group) return;
            const Joint& joint = step.world.joints.hot[breakable.joint];
            note(givenBy(step, joint, store.blocks[block], breakable.lane, substepRate), breakable);
        });
    }
}

void storeJoints(StepContext& step) {
    forJointBlocks(step, [&](const auto& block, const BlockLanes& lanes, float rate) {
        for (int i = 0; i < lanes.count; ++i) {
            Joint& joint = step.world.joints.hot[static_cast<std::size_t>(lanes.index[i])];
            const JointForce given = givenBy(step, joint, block, i, rate);
            joint.force = given.force;
            joint.torque = given.torque;
            storeLane(block, i, rate, joint);
        }
    });
    storeTies(step);
    storeTrees(step);
}

}  // namespace plumb::physics
