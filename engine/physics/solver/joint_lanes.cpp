#include "physics/solver/joint_lanes.hpp"

#include <bit>
#include <type_traits>

#include "physics/joints/joint_types.hpp"
#include "physics/solver/passes.hpp"
#include "physics/trees/joint_tree_solver.hpp"

namespace plumb::physics {

namespace {

constexpr std::size_t kKeysOfGroup = (kColours + 1) * kJointBlockKinds;

// Layout.

/// Returns a key of group, color and block kind of a joint; -1: not solved here, -2 - group: gear or pulley.
std::int32_t keyOf(const World& world, const Workspace& work, std::uint32_t index) {
    const Joint& joint = world.joints.hot[index];
    if (joint.colour > kOverflow || work.joints.trees.isDirect[index] != 0) return -1;
    std::size_t group = 0;
    if (work.groups.size() > 1) {
        const std::int32_t slot = work.slots[pushedBodies(world, joint).b];
        if (slot < 0) return -1;
        while (slot >= work.groups[group].end) ++group;
    }
    const JointType& type = jointType(joint.kind);
    if (type.constraint != nullptr) return -2 - static_cast<std::int32_t>(group);
    return static_cast<std::int32_t>(group * kKeysOfGroup) + joint.colour * kJointBlockKinds +
           type.block(joint.flags);
}

/// @return true if a joint can break or report its load
bool count(StepContext& step) {
    const World& world = step.world;
    Workspace& work = step.work;
    JointWork& joints = work.joints;
    joints.counts.assign(work.groups.size() * kKeysOfGroup, 0);
    joints.keys.resize(world.joints.awake.size());
    collectIf(step, joints.keys.size(), work.pieceFound, [&](std::size_t i) {
        joints.keys[i] = keyOf(world, work, world.joints.awake[i]);
        return (world.joints.hot[world.joints.awake[i]].flags & kBreakable) != 0;
    });
    for (SolveGroup& group : work.groups) group.jointColours = 0;
    for (const std::int32_t key : joints.keys) {
        if (key < 0) continue;
        const auto place = static_cast<std::size_t>(key);
        ++joints.counts[place];
        work.groups[place / kKeysOfGroup].jointColours |= std::uint64_t{1}
                                                          << place % kKeysOfGroup / kJointBlockKinds;
    }
    return !work.pieceFound.empty();
}

/// Assigns ranges of blocks to groups and colors. Converts counts to indices of the next free lane.
template <class Store>
void layOut(Workspace& work, Store& store, JointBlockKind kind) {
    std::int32_t blocks = 0;
    store.groups.clear();
    for (std::size_t g = 0; g < work.groups.size(); ++g) {
        // Gears and pulleys have no color and no blocks.
        std::uint64_t rest = work.groups[g].jointColours | std::uint64_t{1} << kOverflow;
        for (; rest != 0; rest &= rest - 1) {
            const int colour = std::countr_zero(rest);
            std::int32_t& count =
                work.joints.counts[g * kKeysOfGroup + static_cast<std::size_t>(colour) * kJointBlockKinds +
                                   static_cast<std::size_t>(kind)];
            BlockRange& range = work.groups[g].colours[colour].joints[kind];
            range.begin = blocks;
            blocks += colour == kOverflow ? count : (count + kLanes - 1) / kLanes;
            range.end = blocks;
            count = range.begin * kLanes;
        }
        store.groups.resize(static_cast<std::size_t>(blocks), static_cast<std::uint8_t>(g));
    }
    store.blocks.resize(static_cast<std::size_t>(blocks));
    store.lanes.resize(static_cast<std::size_t>(blocks));
}

void fill(const World& world, Workspace& work, bool someBreak) {
    JointWork& joints = work.joints;
    std::vector<BlockLanes>* lanes[kJointBlockKinds] = {&joints.points.lanes, &joints.hinges.lanes,
                                                        &joints.rods.lanes, &joints.sliders.lanes};
    joints.breakables.clear();
    for (std::size_t i = 0; i < joints.keys.size(); ++i) {
        const std::int32_t key = joints.keys[i];
        if (key < 0) continue;
        const std::int32_t kind = key % kJointBlockKinds;
        const bool alone = static_cast<std::size_t>(key) % kKeysOfGroup >= kOverflow * kJointBlockKinds;
        std::int32_t& next = joints.counts[static_cast<std::size_t>(key)];
        const std::int32_t block = next / kLanes, lane = next % kLanes;
        next += alone ? kLanes : 1;
        BlockLanes& target = (*lanes[kind])[static_cast<std::size_t>(block)];
        const std::uint32_t joint = world.joints.awake[i];
        target.index[lane] = static_cast<std::int32_t>(joint);
        target.count = lane + 1;
        if (someBreak && (world.joints.hot[joint].flags & kBreakable) != 0)
            joints.breakables.push_back({joint, kind, block, lane});
    }
}

/// Lists breakable joints of trees. `block` is an index in links, or links.size() plus an index in holds.
void noteBreakables(const World& world, JointWork& joints) {
    const auto note = [&](const std::vector<Link>& links, std::size_t first) {
        for (std::size_t i = 0; i < links.size(); ++i) {
            if (links[i].joint != kNone && joints.trees.isDirect[links[i].joint] != 0 &&
                (world.joints.hot[links[i].joint].flags & kBreakable) != 0)
                joints.breakables.push_back(
                    {links[i].joint, kInTree, static_cast<std::int32_t>(first + i), 0});
        }
    };
    note(joints.trees.links, 0);
    note(joints.trees.holds, joints.trees.links.size());
}

void collectTies(StepContext& step) {
    JointWork& joints = step.work.joints;
    joints.nBodyConstraints.clear();
    for (std::size_t i = 0; i < joints.keys.size(); ++i) {
        if (joints.keys[i] > -2) continue;
        const auto group = static_cast<std::uint8_t>(-2 - joints.keys[i]);
        addTie(step, step.world.joints.awake[i], group);
        step.work.groups[group].jointColours |= std::uint64_t{1} << kOverflow;
    }
}

// Preparation.

/// Input of the preparation of a block.
struct Preparation {
    const World& world;
    const Workspace& work;
    JointTiming timing;
};

/// Returns the offset (bytes) of a slot; for negative slots that of the idle slot of the lane.
std::uint32_t offsetOf(const Preparation& all, std::int32_t slot, int lane) {
    const int place = slot < 0 ? static_cast<int>(all.work.bodyOf.size()) + lane : slot;
    return static_cast<std::uint32_t>(place) * std::uint32_t{sizeof(Float4)};
}

void setBodies(const Preparation& all, const Joint& joint, JointBodies& bodies, int lane) {
    const BodyMass& massA = all.world.bodies.mass[joint.bodyA];
    const std::int32_t a = all.work.slots[joint.bodyA], b = all.work.slots[joint.bodyB];
    const bool pushesA = massA.inverseMass > 0.0f && joint.kind != JointKind::Mouse;
    bodies.a[lane] = offsetOf(all, joint.kind == JointKind::Mouse ? -1 : a, lane);
    bodies.b[lane] = offsetOf(all, b, lane);
    bodies.inverseInertiaA[lane] = pushesA ? massA.inverseInertia : 0.0f;
    bodies.inverseInertiaB[lane] = all.world.bodies.mass[joint.bodyB].inverseInertia;
    bodies.own[lane] = pushesA ? bodies.a[lane] : bodies.b[lane];
    bodies.ownIsA[lane] = pushesA ? 1.0f : 0.0f;
}

/// For joints that also hold the angle, replaces the anchors by a point of B at which the rows are decoupled:
/// there a force does not rotate the bodies relative to each other and a torque does not move the point, so
/// solving the rows sequentially is exact. At an anchor at distance L from a body of gyration radius k, each
/// iteration would leave 1 / (1 + (k / L)^2) of an error, and a motor with this arm would bend the angle.
void balance(JointParts& parts, const JointBodies& bodies, int lane) {
    const float ofA = bodies.inverseInertiaA[lane], ofB = bodies.inverseInertiaB[lane];
    if (!parts.holdsAngle || !(ofA + ofB > 0.0f)) return;
    // Includes the displacement of B on the axis.
    const Vec2 armA = parts.armA + dot(parts.apart, parts.axis) * parts.axis;
    const Vec2 shift = (-1.0f / (ofA + ofB)) * (ofA * armA + ofB * parts.armB);
    const Vec2 shiftA = rotate(rotFromAngle(-parts.angle), shift);
    parts.armA += shiftA;
    parts.armB += shift;
    parts.apart += shift - shiftA;
}

/// A force F along an arm r acts as a rotational spring of angular frequency sqrt(F r / I). If substeps are
/// too long for it, the joint uses the smallest stable inertia, as in trees. Not necessary for a hinge alone,
/// both rows of which are solved together.
float calmed(float inverseInertia, float straining, float h) {
    const float least = static_cast<float>(kCalm) * h * h * std::fabs(straining);  // kg m2
    return inverseInertia * least > 1.0f ? 1.0f / least : inverseInertia;
}

void calm(const JointParts& parts, Vec2 force, float h, JointBodies& bodies, int lane) {
    if (parts.holdsAngle) return;  // balance() makes its arms short
    bodies.inverseInertiaA[lane] = calmed(bodies.inverseInertiaA[lane], dot(parts.armA, force), h);
    bodies.inverseInertiaB[lane] = calmed(bodies.inverseInertiaB[lane], dot(parts.armB, force), h);
}

void setGrip(const Grip& grip, bool springs, float maximum, GripLanes& lanes, int lane) {
    lanes.speedScale[lane] = grip.speedScale;
    lanes.errorRate[lane] = grip.errorRate;
    lanes.impulseScale[lane] = grip.impulseScale;
    lanes.springs[lane] = springs ? 1.0f : 0.0f;
    lanes.maximum[lane] = maximum;
}

void setRows(const Preparation& all, const Joint& joint, const ValueParts& value, RowLanes& rows, int lane) {
    rows.uses |= (value.held ? kHolds : 0) | (value.driven ? kDrives : 0) | (value.limited ? kLimits : 0);
    // A value that is not fixed is a spring without force, in both passes.
    setGrip(value.held ? value.grip : Grip{}, value.springs || !value.held, value.maximum, rows.grip, lane);
    rows.rest[lane] = value.rest;
    rows.speed[lane] = value.speed;
    rows.maxMotor[lane] = value.driven ? value.maxMotor : 0.0f;
    rows.returnSpeed[lane] = value.returnSpeed;
    rows.lower[lane] = value.lower;
    rows.upper[lane] = value.upper;
    const float h = all.timing.h;
    rows.holdImpulse[lane] = value.held ? joint.rows[0] * h : 0.0f;
    rows.motorImpulse[lane] = value.driven ? joint.rows[1] * h : 0.0f;
    rows.lowerImpulse[lane] = value.limited ? joint.rows[2] * h : 0.0f;
    rows.upperImpulse[lane] = value.limited ? joint.rows[3] * h : 0.0f;
}

// Fill the data of a lane except bodies and anchors, for each kind of block. `moment` (N m): torque of the
// joint's force about its anchor, see balance().

void setLane(const Preparation& all, const Joint& joint, const JointParts&, float, PointBlock& block,
             int lane) {
    block.impulse.set(lane, all.timing.h * joint.force);
}

void setLane(const Preparation& all, const Joint& joint, const JointParts& parts, float moment,
             HingeBlock& block, int lane) {
    block.impulse.set(lane, all.timing.h * joint.force);
    setGrip(parts.grip, parts.springs, parts.maximum, block.grip, lane);
    block.angle[lane] = parts.angle;
    setRows(all, joint, parts.value, block.turning, lane);
    block.turning.holdImpulse[lane] -= all.timing.h * moment;
}

void setLane(const Preparation& all, const Joint& joint, const JointParts& parts, float, RodBlock& block,
             int lane) {
    setRows(all, joint, parts.value, block.along, lane);
}

void setLane(const Preparation& all, const Joint& joint, const JointParts& parts, float moment,
             SliderBlock& block, int lane) {
    setRows(all, joint, parts.value, block.along, lane);
    block.axis.set(lane, parts.axis);
    block.angle[lane] = parts.angle;
    block.holdsAngle[lane] = parts.holdsAngle ? 1.0f : 0.0f;
    block.spins |= parts.maxSpin > 0.0f ? 1 : 0;
    block.spin[lane] = parts.spin;
    block.maxSpin[lane] = parts.maxSpin;
    block.acrossImpulse[lane] = joint.rows[4] * all.timing.h;
    const float torque = joint.rows[5] - moment;
    (parts.holdsAngle ? block.angleImpulse : block.spinImpulse)[lane] = torque * all.timing.h;
}

template <class Block>
void prepareBlock(const Preparation& all, const BlockLanes& lanes, Block& block) {
    block = {};
    for (int i = 0; i < lanes.count; ++i) {
        const JointView view = viewOf(all.world, static_cast<std::uint32_t>(lanes.index[i]), all.timing);
        setBodies(all, view.joint, block.bodies, i);
        JointParts parts = jointType(view.joint.kind).parts(view);
        const Vec2 anchorArm = parts.armB;
        balance(parts, block.bodies, i);
        if constexpr (!std::is_same_v<Block, PointBlock>)
            calm(parts, view.joint.force, all.timing.h, block.bodies, i);
        block.anchors.armA.set(i, parts.armA);
        block.anchors.armB.set(i, parts.armB);
        block.anchors.apart.set(i, parts.apart);
        const float moment = cross(parts.armB - anchorArm, view.joint.force);
        setLane(all, view.joint, parts, moment, block, i);
    }
    JointBodies& idle = block.bodies;
    for (int i = lanes.count; i < kLanes; ++i) idle.a[i] = idle.b[i] = idle.own[i] = offsetOf(all, -1, i);
}

}  // namespace

void prepareJoints(StepContext& step) {
    World& world = step.world;
    Workspace& work = step.work;
    const bool someBreak = count(step);
    forKinds(work.joints, [&](auto& store, JointBlockKind kind) { layOut(work, store, kind); });
    fill(world, work, someBreak);
    collectTies(step);
    noteBreakables(world, work.joints);
    prepareTrees(step);
    forJointBlocks(step, [&](auto& block, const BlockLanes& lanes, float rate) {
        const float h = 1.0f / rate;
        const JointTiming timing{h, world.settings.jointStiffness / h, jointPass(world.settings, h).rigid};
        prepareBlock({world, work, timing}, lanes, block);
    });
}

void solveJoints(const StepContext& step, const SolverBodies& bodies, const JointPass& pass,
                 const SolveGroup& group, int colour, PassKind kind) {
    if ((group.jointColours >> colour & 1) == 0) return;
    const JointKernels& joints = solverKernels().joints;
    if (colour == kOverflow) solveTies(step.work, pass, group, kind);
    forKinds(step.work.joints, [&]<class Block>(JointStore<Block>& store, JointBlockKind blocks) {
        const BlockRange range = group.colours[colour].joints[blocks];
        if (range.begin == range.end) return;
        const JointPasses<Block>& kernels = joints;
        const auto& passes = kernels.passes[static_cast<std::size_t>(kind)];
        const auto run = [&, lanes = store.lanes.data(), all = store.blocks.data()](bool oneSided, int first,
                                                                                    int last) {
            passes[oneSided](bodies, pass, lanes, all, first, last);
        };
        if (colour != kOverflow) {
            return forRange(step, range, kJointGrain,
                            [=](int first, int last) { run(colour >= kFirstFixedColour, first, last); });
        }
        // Joints without a color may share bodies, so they are solved sequentially, each in a separate block.
        for (int n = range.begin; n < range.end; ++n) {
            const auto joint = static_cast<std::size_t>(store.lanes[static_cast<std::size_t>(n)].index[0]);
            run(pushedBodies(step.world, step.world.joints.hot[joint]).a == kNone, n, n + 1);
        }
    });
}

}  // namespace plumb::physics
