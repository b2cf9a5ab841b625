#include "physics/trees/joint_tree_solver.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "physics/joints/joint_types.hpp"
#include "physics/trees/tree_drives.hpp"
#include "physics/trees/tree_joints.hpp"

namespace plumb::physics {

namespace {

constexpr int kTreeGrain = 8;  // trees

/// Compliance of a row that no impulse can change; so large that its impulse is zero.
constexpr double kNoAnswer = 1.0e30;

struct Trees {
    Workspace& work;
    JointTrees& all;
    double h;         // s
    double rate;      // 1/h
    double elapsed;   // s: time in the step at which rows are evaluated
    double farthest;  // m or rad: maximum reduction of a gap in a substep

    [[nodiscard]] TreeBody& treeBodyOf(const Link& link) const { return all.treeBodies[link.treeBody]; }
    [[nodiscard]] TreeBody* parentOf(const Link& link) const {
        return link.parent != kNone ? &all.treeBodies[link.parent] : nullptr;
    }
};

Triple tripleOf(const Float4& v) {
    return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

PoseChange parentPoseChange(const Link& link, const TreeBody* parent, double elapsed) {
    if (parent != nullptr) return parent->poseChange;
    const Triple& v = link.groundVelocity;
    const PoseChange moved{v.x * elapsed, v.y * elapsed, 0.0, 0.0};
    return v.turn == 0.0 ? moved : turnedBy(moved, v.turn * elapsed);
}

double offered(const TreeBody& treeBody, const Triple& row) {
    const double turned = treeBody.inertia > 0.0 ? row.turn * row.turn / treeBody.inertia : 0.0;
    return (row.x * row.x + row.y * row.y) / treeBody.mass + turned;
}

/// Computes the softness of rows, only at the start of the step because it hardly changes.
void soften(const TreeBody& treeBody, Link& link, const TreeBody* parent) {
    const auto softness = [&](int r, Triple onTreeBody, Triple onParent) {
        // Unused rows, and angle rows of two bodies that cannot rotate, must get no impulse.
        if (r >= (link.drive.on ? 3 : rowsOf(link.kind))) return 1.0;
        const double all =
            offered(treeBody, onTreeBody) + (parent != nullptr ? offered(*parent, onParent) : 0.0);
        return all > 0.0 ? kTreeSoftness * all : kNoAnswer;
    };
    if (link.byArms()) {
        link.softness = {softness(0, {1.0, 0.0, link.limb.y}, {1.0, 0.0, link.parentLimb.y}),
                         softness(1, {0.0, 1.0, link.limb.x}, {0.0, 1.0, link.parentLimb.x}),
                         softness(2, link.onTreeBody[2], link.onParent[2])};
    } else {
        link.softness = {softness(0, link.onTreeBody[0], link.onParent[0]),
                         softness(1, link.onTreeBody[1], link.onParent[1]),
                         softness(2, link.onTreeBody[2], link.onParent[2])};
    }
    link.drive.softness = kDriveSoftness / kTreeSoftness * link.softness.turn;
}

void setLink(const Trees& trees, Link& link) {
    TreeBody* const parent = trees.parentOf(link);
    TreeBody& treeBody = trees.treeBodyOf(link);
    const PoseChange parentPose = parentPoseChange(link, parent, trees.elapsed);
    link.gap = setRows(link, treeBody.poseChange, parentPose);
    if (trees.elapsed == 0.0) soften(treeBody, link, parent);
    // The velocity of a hinge needs no angle, so this is needed for limits only.
    if (link.drive.on && (link.drive.limited || link.kind != JointKind::Revolute))
        link.drive.value = valueOf(link, treeBody.poseChange, parentPose);
    // Only joints that fix a point have these arms.
    if (link.kind != JointKind::Revolute && link.kind != JointKind::Weld) return;
    treeBody.straining += link.force.x * link.limb.x + link.force.y * link.limb.y;
    if (parent != nullptr)
        parent->straining -= link.force.x * link.parentLimb.x + link.force.y * link.parentLimb.y;
}

void takeMotion(const Trees& trees, TreeBody& treeBody) {
    const auto slot = static_cast<std::size_t>(treeBody.slot);
    const Float4& moved = trees.work.deltaPosition[slot];
    treeBody.poseChange = {double{moved.x}, double{moved.y}, double{moved.z}, double{moved.w}};
    treeBody.velocity = tripleOf(trees.work.velocity[slot]);
    treeBody.impulse = {};
}

/// Factors the system of masses and rows.
void factorTree(const Trees& trees, const JointTree& tree) {
    forDrives(trees.all, tree,
              [](Link& link) { link.softness.turn = link.drive.exerts ? kNoAnswer : link.drive.softness; });
    for (TreeBody& treeBody : trees.all.bodiesOf(tree)) {
        const double inertia = std::max(treeBody.inertia, kCalm * trees.h * trees.h * treeBody.straining);
        treeBody.own = {treeBody.mass, 0.0, treeBody.mass, 0.0, 0.0, inertia};
    }
    for (Link& hold : trees.all.holdsOf(tree)) {
        const double turning = hold.hasTwoRows() ? 0.0 : 1.0 / hold.softness.turn;
        hold.stiffness = {1.0 / hold.softness.x, 0.0, 1.0 / hold.softness.y, 0.0, 0.0, turning};
        Symmetric& own = trees.treeBodyOf(hold).own;
        hold.byArms() ? addPoint(hold.limb.x, hold.limb.y, hold.stiffness, own)
                      : addRows(hold.onTreeBody, hold.stiffness, own);
    }
    for (std::uint32_t i = tree.begin; i < tree.end; ++i) {
        TreeBody& treeBody = trees.all.treeBodies[i];
        treeBody.own = treeBody.inertia > 0.0 ? inverse(treeBody.own) : inverseUnturned(treeBody.own);
        if (hasLink(tree, i)) stiffen(treeBody, trees.all.links[i], trees.parentOf(trees.all.links[i]));
    }
}

/// Updates motions, rows and gaps to the current poses, and factors the system.
void setTree(const Trees& trees, const JointTree& tree) {
    for (TreeBody& treeBody : trees.all.bodiesOf(tree)) {
        takeMotion(trees, treeBody);
        treeBody.straining = 0.0;
    }
    forLinks(trees.all, tree, [&](Link& link) { setLink(trees, link); });
    factorTree(trees, tree);
}

/// Predicts the pose of a tree body at the end of the substep, without joint impulses.
void lookAhead(const Trees& trees, TreeBody& treeBody) {
    const Float4& ballisticDrift = trees.work.ballisticDrift[static_cast<std::size_t>(treeBody.slot)];
    const auto time = static_cast<double>(ballisticDrift.z);
    treeBody.poseChange = turnedBy(treeBody.poseChange, treeBody.velocity.turn * trees.h);
    treeBody.poseChange.x += treeBody.velocity.x * time + static_cast<double>(ballisticDrift.x);
    treeBody.poseChange.y += treeBody.velocity.y * time + static_cast<double>(ballisticDrift.y);
}

/// Returns the lengths by which the gaps of a link are closed within a substep.
Triple closedOf(const Trees& trees, const Link& link) {
    const auto closed = [&](double gap) { return std::clamp(gap, -trees.farthest, trees.farthest); };
    return {closed(link.gap.x), closed(link.gap.y), closed(link.gap.turn)};
}

/// Computes the velocities of a drive for a pass, from the velocity of its value without impulses.
void aimDrive(const Trees& trees, Link& link, double velocity, bool closes) {
    Drive& drive = link.drive;
    const auto approach = [&](double room) {
        if (!drive.limited) return -std::numeric_limits<double>::infinity();
        return std::min(-room * trees.rate, room > 0.0 || closes ? drive.returnSpeed : 0.0);
    };
    drive.velocity = velocity;
    drive.slowest = approach(drive.value - drive.lower);
    drive.fastest = -approach(drive.upper - drive.value);
}

/// Returns the relative velocities of a link's rows.
Triple speedsOf(const Trees& trees, const Link& link) {
    const TreeBody* const parent = trees.parentOf(link);
    return seenFromLimb(link, trees.treeBodyOf(link).velocity) +
           seenFromParent(link, parent != nullptr ? parent->velocity : link.groundVelocity);
}

/// Computes the velocities to remove so that a part of the gaps is closed at the predicted poses.
void aimAtGaps(const Trees& trees, Link& link, double part) {
    const PoseChange parent = parentPoseChange(link, trees.parentOf(link), trees.elapsed + trees.h);
    const PoseChange& treeBody = trees.treeBodyOf(link).poseChange;
    const Triple ahead = gapsOf(link, treeBody, parent);
    link.error = trees.rate * ((ahead - link.gap) + part * closedOf(trees, link));
    if (!link.drive.on) return;
    const double velocity = link.byArms() ? speedsOf(trees, link).turn
                                          : (valueOf(link, treeBody, parent) - link.drive.value) * trees.rate;
    aimDrive(trees, link, velocity, true);
}

void findSpeeds(const Trees& trees, Link& link) {
    link.error = speedsOf(trees, link);
    if (link.drive.on) aimDrive(trees, link, link.error.turn, false);
}

/// Adds a change of velocity also to velocityBeforeImpulses, so that warm starting does not repeat it.
void addChange(const Trees& trees, const TreeBody& treeBody, const Triple& change) {
    const auto slot = static_cast<std::size_t>(treeBody.slot);
    for (Float4* velocity : {&trees.work.velocity[slot], &trees.work.velocityBeforeImpulses[slot]}) {
        velocity->x = static_cast<float>(static_cast<double>(velocity->x) + change.x);
        velocity->y = static_cast<float>(static_cast<double>(velocity->y) + change.y);
        velocity->z = static_cast<float>(static_cast<double>(velocity->z) + change.turn);
    }
}

/// Returns the change of a tree body's kinetic energy (J) by a change of its velocity.
double gainOf(const TreeBody& treeBody, const Triple& change) {
    return treeBody.mass * ((treeBody.velocity.x + 0.5 * change.x) * change.x +
                            (treeBody.velocity.y + 0.5 * change.y) * change.y) +
           treeBody.inertia * (treeBody.velocity.turn + 0.5 * change.turn) * change.turn;
}

/// Elimination, from the leaves to the root.
void answerTree(const Trees& trees, const JointTree& tree) {
    for (Link& hold : trees.all.holdsOf(tree)) {
        TreeBody& treeBody = trees.treeBodyOf(hold);
        exertDrive(treeBody, hold, nullptr);
        hold.answer = -1.0 * (hold.stiffness * hold.error);
        treeBody.impulse += onTreeBody(hold, hold.answer);
    }
    for (std::uint32_t i = tree.begin; i < tree.end; ++i) {
        if (!hasLink(tree, i)) continue;
        Link& link = trees.all.links[i];
        answer(trees.all.treeBodies[i], link, trees.parentOf(link));
    }
}

/// Back substitution, from the root to the leaves: computes velocity changes and impulses of links.
void giveTree(const Trees& trees, const JointTree& tree) {
    for (std::uint32_t i = tree.end; i-- > tree.begin;) {
        TreeBody& treeBody = trees.all.treeBodies[i];
        if (hasLink(tree, i)) {
            give(treeBody, trees.all.links[i], trees.parentOf(trees.all.links[i]));
        } else {
            treeBody.impulse = treeBody.own * treeBody.impulse;
        }
    }
    for (Link& hold : trees.all.holdsOf(tree))
        hold.answer += -1.0 * (hold.stiffness * seenFromLimb(hold, trees.treeBodyOf(hold).impulse));
}

/// Applies the computed velocity changes and impulses.
void applyTree(const Trees& trees, JointTree& tree) {
    for (std::uint32_t i = tree.end; i-- > tree.begin;) {
        const TreeBody& treeBody = trees.all.treeBodies[i];
        if (hasLink(tree, i)) trees.all.links[i].given += trees.all.links[i].answer;
        addChange(trees, treeBody, treeBody.impulse);
        tree.gain += gainOf(treeBody, treeBody.impulse);
    }
    for (Link& hold : trees.all.holdsOf(tree)) hold.given += hold.answer;
    forDrives(trees.all, tree, [&](Link& link) {
        // The work of a motor is no gain.
        const double before = std::exchange(link.drive.ofMotor, motorImpulseOf(link.drive));
        const double velocity = link.drive.velocity + 0.5 * velocityChangeOf(trees.all, link);
        tree.gain -= (link.drive.ofMotor - before) * velocity;
        if (link.drive.exerts) link.given.turn = link.drive.impulse;
    });
}

/// Removes energy from a tree that gained too much, by scaling all velocities equally, which opens no joint.
/// Velocities of a floating tree are scaled relative to its center of mass.
void calmTree(const Trees& trees, JointTree& tree) {
    Triple middle;
    double mass = 0.0, energy = 0.0;
    for (TreeBody& treeBody : trees.all.bodiesOf(tree)) {
        treeBody.velocity += treeBody.impulse;
        energy += -gainOf(treeBody, -1.0 * treeBody.velocity);
        middle += treeBody.mass * Triple{treeBody.velocity.x, treeBody.velocity.y, 0.0};
        mass += treeBody.mass;
    }
    const double excess = tree.gain - kTreeGain * energy;
    if (excess <= 0.0 || tree.powered) return;
    middle = tree.rooted ? Triple{} : 1.0 / mass * middle;
    const double own = energy - 0.5 * mass * (middle.x * middle.x + middle.y * middle.y);
    const double less = own > excess ? 1.0 - std::sqrt(1.0 - excess / own) : 1.0;
    for (const TreeBody& treeBody : trees.all.bodiesOf(tree))
        addChange(trees, treeBody, -less * (treeBody.velocity - middle));
    tree.gain -= excess;
}

/// Solves a tree: removes the errors of all links, which `find` stores in Link::error.
template <class Find>
void solveTree(const Trees& trees, JointTree& tree, Find&& find) {
    forLinks(trees.all, tree, [&](Link& link) { find(trees, link); });
    bool released = false;
    for (int round = 0;; ++round) {
        if (round > 0) {
            for (TreeBody& treeBody : trees.all.bodiesOf(tree)) treeBody.impulse = {};
            factorTree(trees, tree);
        }
        forDrives(trees.all, tree, [](Link& link) {
            const Drive& drive = link.drive;
            link.error.turn = drive.exerts ? 0.0 : drive.velocity - targetOf(drive, drive.range);
        });
        answerTree(trees, tree);
        giveTree(trees, tree);
        if (!tree.drives || round == kMaxRounds) break;
        if (stopAtEnds(trees.all, tree)) continue;
        if (!releaseDrives(trees.all, tree, !released)) break;
        released = true;
    }
    applyTree(trees, tree);
}

/// Returns the work (J) of external accelerations in a substep on the computed velocity changes.
double workOfFields(const Trees& trees, const JointTree& tree) {
    double work = 0.0;
    for (const TreeBody& treeBody : trees.all.bodiesOf(tree)) {
        const Triple acceleration = tripleOf(trees.work.drive[static_cast<std::size_t>(treeBody.slot)]);
        const Triple& change = treeBody.impulse;
        work += treeBody.mass * (acceleration.x * change.x + acceleration.y * change.y) +
                treeBody.inertia * acceleration.turn * change.turn;
    }
    return trees.h * work;
}

/// Determines the part of its gaps that a tree closes in this substep. Those left by the SIMD solver move no
/// body faster than Settings::pushSpeed: closed at once, they would throw the bodies of long or taut trees.
void limitClosing(const Trees& trees, JointTree& tree) {
    tree.part = 1.0;
    if (!tree.stretched) return;
    forLinks(trees.all, tree, [&](Link& link) { link.error = trees.rate * closedOf(trees, link); });
    answerTree(trees, tree);
    giveTree(trees, tree);
    const double work = workOfFields(trees, tree);
    double square = 0.0;
    for (TreeBody& treeBody : trees.all.bodiesOf(tree)) {
        const Triple v = std::exchange(treeBody.impulse, {});
        square = std::max(square, v.x * v.x + v.y * v.y);
    }
    const double most = trees.rate * trees.farthest / static_cast<double>(kJointPushing);
    if (square > most * most) tree.part = most / std::sqrt(square);
    tree.stretched = tree.part < 1.0;
    tree.lift += std::max(0.0, -tree.part * work);
}

void pushTree(const Trees& trees, JointTree& tree, bool again) {
    if (!again) {
        tree.gain = 0.0;
        if (trees.elapsed == 0.0) {  // later substeps reuse the factors of the relax pass
            forDrives(trees.all, tree, [&](Link& link) { startDrive(link.drive, trees.h); });
            setTree(trees, tree);
        }
        forLinks(trees.all, tree, [](Link& link) { link.given = {}, link.drive.ofMotor = 0.0; });
    }
    for (TreeBody& treeBody : trees.all.bodiesOf(tree)) {
        takeMotion(trees, treeBody);
        lookAhead(trees, treeBody);
    }
    if (!again) limitClosing(trees, tree);
    solveTree(trees, tree, [&](const Trees&, Link& link) { aimAtGaps(trees, link, tree.part); });
    // Impulses act on velocities after these accelerations, but joints also keep those before them.
    if (tree.drives && !again) tree.gain -= std::max(0.0, 0.5 * workOfFields(trees, tree));
}

void relaxTree(const Trees& trees, JointTree& tree, bool again) {
    if (again) {
        for (TreeBody& treeBody : trees.all.bodiesOf(tree)) takeMotion(trees, treeBody);
    } else {
        setTree(trees, tree);
    }
    solveTree(trees, tree, findSpeeds);
    if (tree.gain > 0.0) calmTree(trees, tree);
    forLinks(trees.all, tree, [&](Link& link) {
        link.force = trees.rate * onTreeBody(link, link.given);
        const bool turns = link.kind == JointKind::Weld || link.drive.on;
        const double impulse = turns ? link.given.turn : 0.0;
        link.force.turn = trees.rate * (link.kind == JointKind::Prismatic ? link.given.y : impulse);
    });
}

/// Sets motor and limits of a link, and their force in the last step.
void prepareDrive(const JointView& view, Link& link) {
    const Joint& joint = view.joint;
    const bool canDrive = link.kind == JointKind::Revolute || link.kind == JointKind::Prismatic;
    link.drive = {.on = canDrive && (joint.flags & (kLimited | kDriven)) != 0};
    if (!link.drive.on) return;
    Drive& drive = link.drive;
    const JointLimit limit = limitOf(view);
    const JointMotor& motor = view.definition.motor;
    const double sign = link.treeBodyIsB ? 1.0 : -1.0;
    drive.limited = limit.on;
    drive.returnSpeed = static_cast<double>(returnSpeedOf(view));
    drive.lower = static_cast<double>(link.treeBodyIsB ? limit.lower : -limit.upper);
    drive.upper = static_cast<double>(link.treeBodyIsB ? limit.upper : -limit.lower);
    drive.speed = motor.on ? sign * static_cast<double>(motor.speed) : 0.0;
    drive.maxForce = motor.on ? static_cast<double>(std::min(motor.maxForce, kNoLimit)) : 0.0;
    drive.force = sign * static_cast<double>(joint.rows[1] + (joint.rows[2] - joint.rows[3]));
}

void prepareArms(const World& world, Link& link) {
    const JointTiming timing{};
    const JointView view = viewOf(world, link.joint, timing);
    const JointParts parts = anchorsOf(view);
    const float sign = link.treeBodyIsB ? 1.0f : -1.0f;
    link.treeBodyArm = link.treeBodyIsB ? parts.armB : parts.armA;
    link.parentArm = link.treeBodyIsB ? parts.armA : parts.armB;
    link.apart = sign * parts.apart;
    if (link.kind == JointKind::Distance) link.rest = view.definition.length;
    prepareDrive(view, link);
    if (link.kind == JointKind::Weld || link.kind == JointKind::Prismatic || link.drive.on)
        link.angle = sign * angleOf(view);
    if (link.kind == JointKind::Prismatic) link.axis = rotate(view.rotationA, view.definition.axis);
    const Vec2 force = sign * view.joint.force;
    link.force = {static_cast<double>(force.x), static_cast<double>(force.y), 0.0};
}

}  // namespace

void prepareTrees(StepContext& step) {
    const World& world = step.world;
    JointTrees& all = step.work.joints.trees;
    for (JointTree& tree : all.trees) {
        if (!tree.direct) continue;
        for (TreeBody& treeBody : all.bodiesOf(tree)) {
            const BodyMass& mass = world.bodies.mass[treeBody.body];
            treeBody.slot = step.work.slots[treeBody.body];
            treeBody.mass = 1.0 / std::max(double{mass.inverseMass}, 1.0e-30);
            treeBody.inertia = mass.inverseInertia > 0.0f ? 1.0 / double{mass.inverseInertia} : 0.0;
        }
        tree.powered = tree.drives = tree.stretched = false;
        tree.lift = 0.0;
        forLinks(all, tree, [&](Link& link) {
            prepareArms(world, link);
            tree.drives |= link.drive.on;
            const std::int32_t slot = link.parent == kNone ? step.work.slots[link.ground] : -1;
            link.groundVelocity =
                slot >= 0 ? tripleOf(step.work.velocity[static_cast<std::size_t>(slot)]) : Triple{};
            const Triple& v = link.groundVelocity;
            const std::uint8_t flags = world.joints.hot[link.joint].flags;
            tree.stretched |= (flags & kStretched) != 0;
            // A shorter rope does work on what swings on it; changed limits do none.
            const bool isEdited = !link.drive.on && (flags & kEdited) != 0;
            tree.powered |= isEdited || dot(v, v) > 0.0;
        });
        const std::int32_t slot = all.bodiesOf(tree).front().slot;
        tree.group = 0;
        while (slot >= step.work.groups[tree.group].end) ++tree.group;
    }
}

void solveTrees(StepContext& step, const SolveGroup& group, PassKind kind, float h, int substep, bool again) {
    JointTrees& all = step.work.joints.trees;
    const auto dt = static_cast<double>(h);
    const bool relaxes = kind == PassKind::Relax;
    const double farthest = dt * static_cast<double>(kJointPushing * step.world.settings.pushSpeed);
    const Trees trees{step.work, all, dt, 1.0 / dt, dt * (relaxes ? substep + 1 : substep), farthest};
    forEach(step.pool, all.trees.size(), kTreeGrain, [&](std::size_t t) {
        JointTree& tree = all.trees[t];
        if (!tree.direct || &step.work.groups[tree.group] != &group) return;
        relaxes ? relaxTree(trees, tree, again) : pushTree(trees, tree, again);
    });
}

JointForce forceOf(const Link& link) {
    const double sign = link.treeBodyIsB ? 1.0 : -1.0;
    return {{static_cast<float>(sign * link.force.x), static_cast<float>(sign * link.force.y)},
            static_cast<float>(sign * link.force.turn)};
}

void storeTrees(StepContext& step) {
    JointTrees& all = step.work.joints.trees;
    for (const JointTree& tree : all.trees) {
        if (!tree.direct) continue;
        step.world.bodies.energies.resize(step.world.bodies.size());
        const float rate = static_cast<float>(step.work.groups[tree.group].substeps) / step.dt;
        step.world.bodies.energies[all.treeBodies[tree.begin].body].credit += static_cast<float>(tree.lift);
        forLinks(all, tree, [&](const Link& link) {
            Joint& joint = step.world.joints.hot[link.joint];
            if (!tree.stretched) joint.flags &= static_cast<std::uint8_t>(~kStretched);
            const JointForce force = forceOf(link);
            joint.force = force.force;
            joint.torque = force.torque;
            // Warm starting values, in case the SIMD solver solves the tree in the next step.
            const float sign = link.treeBodyIsB ? rate : -rate;
            const auto row = [&](double given) { return static_cast<float>(given) * sign; };
            if (link.kind == JointKind::Weld) joint.rows[0] = row(link.given.turn);
            if (link.kind == JointKind::Distance) joint.rows[0] = rate * static_cast<float>(link.given.x);
            if (link.kind == JointKind::Prismatic)
                joint.rows[4] = row(link.given.x), joint.rows[5] = row(link.given.y);
            if (!link.drive.on) return;
            const float total = row(link.given.turn);
            joint.rows[1] = row(motorImpulseOf(link.drive));
            joint.rows[2] = std::max(total - joint.rows[1], 0.0f);
            joint.rows[3] = std::max(joint.rows[1] - total, 0.0f);
        });
        for (const Link& hold : all.holdsOf(tree))  // even while there are gaps: leave()
            step.world.joints.hot[hold.joint].flags &= static_cast<std::uint8_t>(~kStretched);
    }
}

}  // namespace plumb::physics
