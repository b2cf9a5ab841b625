#include <algorithm>
#include <cmath>

#include "physics/model/joints.hpp"
#include "physics/solver/joint_lanes.hpp"
#include "physics/solver/n_body_joints.hpp"
#include "physics/trees/joint_tree_solver.hpp"

namespace plumb::physics {

namespace {

constexpr int kGrain = 24;  // blocks

float totalOf(const RowLanes& rows, int i) {
    return rows.holdImpulse[i] + rows.motorImpulse[i] + (rows.lowerImpulse[i] - rows.upperImpulse[i]);
}

/// N m: at B's anchor, of a force at the point that stands for it (balanced).
float momentOf(const StepContext& step, const Joint& joint, const JointBodies& bodies,
               const AnchorLanes& anchors, int i, Vec2 force) {
    const Vec2 shift = Vec2{anchors.armBX[i], anchors.armBY[i]} -
                       rotate(step.world.bodies.pose[joint.bodyB].rotation, joint.anchorB);
    const Float4& turned = step.work.deltaPosition[static_cast<std::size_t>(bodies.b[i])];
    return cross(rotate(Rot{1.0f + turned.w, turned.z}, shift), force);
}

JointForce givenBy(const StepContext&, const Joint&, const PointBlock& block, int i, float rate) {
    return {{block.impulseX[i] * rate, block.impulseY[i] * rate}, 0.0f};
}
JointForce givenBy(const StepContext& step, const Joint& joint, const HingeBlock& block, int i, float rate) {
    const Vec2 force = givenBy(step, joint, block.point, i, rate).force;
    return {force, totalOf(block.turning, i) * rate +
                       momentOf(step, joint, block.point.bodies, block.point.anchors, i, force)};
}
JointForce givenBy(const StepContext& step, const Joint&, const RodBlock& block, int i, float rate) {
    const Workspace& work = step.work;
    const auto arm = [&](const float* x, const float* y, const std::int32_t* slot) {
        const Float4& deltaPosition = work.deltaPosition[static_cast<std::size_t>(slot[i])];
        return Vec2{deltaPosition.x, deltaPosition.y} +
               rotate(Rot{1.0f + deltaPosition.w, deltaPosition.z}, {x[i], y[i]}) - Vec2{x[i], y[i]};
    };
    const Vec2 apart = Vec2{block.anchors.apartX[i], block.anchors.apartY[i]} +
                       (arm(block.anchors.armBX, block.anchors.armBY, block.bodies.b) -
                        arm(block.anchors.armAX, block.anchors.armAY, block.bodies.a));
    return {totalOf(block.along, i) * rate * normalized(apart), 0.0f};
}
JointForce givenBy(const StepContext& step, const Joint& joint, const SliderBlock& block, int i, float rate) {
    const Float4& deltaPosition = step.work.deltaPosition[static_cast<std::size_t>(block.bodies.a[i])];
    const Vec2 axis = rotate(Rot{1.0f + deltaPosition.w, deltaPosition.z}, {block.axisX[i], block.axisY[i]});
    const Vec2 force = rate * (totalOf(block.along, i) * axis + block.acrossImpulse[i] * perpendicular(axis));
    return {force, rate * (block.angleImpulse[i] + block.spinImpulse[i]) +
                       momentOf(step, joint, block.bodies, block.anchors, i, force)};
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

template <class Block>
void note(const StepContext& step, const JointStore<Block>& store, float rate, BreakableJoint& breakable) {
    const JointForce given =
        givenBy(step, step.world.joints.hot[breakable.joint],
                store.blocks[static_cast<std::size_t>(breakable.block)], breakable.lane, rate);
    breakable.force = std::max(breakable.force, length(given.force));
    breakable.torque = std::max(breakable.torque, std::fabs(given.torque));
}

void noteInTree(StepContext& step, const SolveGroup& group, BreakableJoint& breakable) {
    const JointTrees& trees = step.work.joints.trees;
    const auto place = static_cast<std::size_t>(breakable.block);
    const Link& link =
        place < trees.links.size() ? trees.links[place] : trees.holds[place - trees.links.size()];
    const std::int32_t slot = trees.treeBodies[static_cast<std::size_t>(link.treeBody)].slot;
    if (slot < group.begin || slot >= group.end) return;
    const JointForce given = forceOf(link);
    breakable.force = std::max(breakable.force, length(given.force));
    breakable.torque = std::max(breakable.torque, std::fabs(given.torque));
}

void breakJoints(World& world, JointWork& joints) {
    for (const BreakableJoint& breakable : joints.breakables) {
        const JointDefinition& definition = world.joints.definition[breakable.joint];
        const auto exceeds = [&](float force, float torque) {
            return breakable.force > force || breakable.torque > torque;
        };
        if (world.joints.hot[breakable.joint].bodyA == kNone) continue;  // already broken
        const JointId id{breakable.joint, world.joints.hot[breakable.joint].generation};
        if (exceeds(definition.reportForce, definition.reportTorque)) world.strainedJoints.push_back(id);
        if (!exceeds(definition.breakForce, definition.breakTorque)) continue;
        world.brokenJoints.push_back(id);
        destroyJoint(world, id);
    }
}

}  // namespace

void noteJointForces(StepContext& step, const SolveGroup& group, float substepRate) {
    if (!step.world.manifest.runs(Effect::Joints)) return;  // breakables are those of an earlier step
    JointWork& joints = step.work.joints;
    for (BreakableJoint& breakable : joints.breakables) {
        if (breakable.kind == kInTree) noteInTree(step, group, breakable);
        forKinds(joints, [&](auto& store, JointBlockKind kind) {
            if (breakable.kind != kind) return;
            if (&step.work.groups[store.groups[static_cast<std::size_t>(breakable.block)]] != &group) return;
            note(step, store, substepRate, breakable);
        });
    }
}

void storeJoints(StepContext& step) {
    forKinds(step.work.joints, [&](auto& store, JointBlockKind) {
        forPieces(step, static_cast<int>(store.blocks.size()), kGrain, [&](int begin, int end, int) {
            for (auto n = static_cast<std::size_t>(begin); n < static_cast<std::size_t>(end); ++n) {
                const float rate = rateOf(step, store.groups[n]);
                for (int i = 0; i < store.lanes[n].count; ++i) {
                    Joint& joint = step.world.joints.hot[static_cast<std::size_t>(store.lanes[n].joint[i])];
                    const JointForce given = givenBy(step, joint, store.blocks[n], i, rate);
                    joint.force = given.force;
                    joint.torque = given.torque;
                    storeLane(store.blocks[n], i, rate, joint);
                }
            }
        });
    });
    storeTies(step);
    storeTrees(step);
    breakJoints(step.world, step.work.joints);
}

}  // namespace plumb::physics
