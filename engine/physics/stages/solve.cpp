#include <algorithm>

#include "physics/solver/contact_extras.hpp"
#include "physics/solver/joint_lanes.hpp"
#include "physics/solver/passes.hpp"
#include "physics/stages.hpp"
#include "physics/trees/joint_tree_solver.hpp"

namespace plumb::physics {

namespace {

// Axis locks: after each pass the velocity along a locked axis is reset to 0.

void lock(Float4& row, std::uint8_t flags) {
    if ((flags & kLockX) != 0) row.x = 0.0f;
    if ((flags & kLockY) != 0) row.y = 0.0f;
}

void prepareLocks(StepContext& step) {
    if (!step.starts(Effect::Locks)) return;
    Workspace& work = step.work;
    work.locks.clear();
    for (std::size_t slot = 0; slot < work.bodyOf.size(); ++slot) {
        const std::uint32_t body = work.bodyOf[slot];
        if (body == kNone || !isDynamic(step.world, body)) continue;
        const auto flags = static_cast<std::uint8_t>(step.world.bodies.info[body].flags & (kLockX | kLockY));
        if (flags == 0) continue;
        work.locks.push_back({static_cast<std::uint32_t>(slot), flags});
        for (std::vector<Float4>* rows : {&work.velocity, &work.drive, &work.ballisticDrift})
            lock((*rows)[slot], flags);
    }
}

/// State of a group while its substeps are solved. Groups without rotation have no joints, soft bodies or
/// restitution.
template <class Bodies>
struct Solver {
    StepContext& step;
    const GroupKernels<Bodies>& kernels;
    const SolveGroup& group;
    const Bodies& bodies;
    ContactSets<Bodies>& contacts;
    JointPass joints;
    float h;         // s
    int iterations;  // per substep
    bool hasTrees;

    [[nodiscard]] bool has(std::int32_t slot) const { return slot >= group.begin && slot < group.end; }

    /// Calls act(soft group) for the soft groups that push bodies of this group.
    template <class Act>
    void forSoft(Act&& act) const {
        if (!Bodies::kRotate || !step.runs(Effect::SoftBodies)) return;
        for (const SoftGroup& soft : step.work.softSurroundings.groups) {
            if (soft.body != kNone && has(step.work.slots[soft.body])) act(soft);
        }
    }

    /// Performs one pass over all constraints, color by color: joints, then contacts.
    void forConstraints(PassKind kind) {
        forColours(group.contactColours | group.jointColours, [&](int colour, int grain) {
            if constexpr (Bodies::kRotate) solveJoints(step, bodies, joints, group, colour, kind);
            if ((group.contactColours >> colour & 1) == 0) return;
            const ContactRanges& ranges = group.colours[colour].contacts;
            contacts.two.run(step, bodies, ranges.two, grain, kind);
            contacts.fixed.run(step, bodies, ranges.fixed, grain, kind);
        });
    }

    void resetLocked() {
        if (!step.runs(Effect::Locks)) return;
        for (const AxisLock& held : step.work.locks) {
            const auto slot = static_cast<std::int32_t>(held.slot);
            if (has(slot)) lock(bodies.velocity[slot], held.flags);
        }
    }

    /// Computes velocities that satisfy the constraints; the biased pass also corrects position errors.
    template <PassKind kKind>
    void iterate(int substep) {
        constexpr bool kRelaxes = kKind == PassKind::Relax;
        for (int iteration = 0; iteration < iterations; ++iteration) {
            joints.first = iteration == 0;
            forSoft([&](const SoftGroup& soft) { solveSoft(step, soft, contacts.two.pass, kRelaxes); });
            if (hasTrees) solveTrees(step, group, kKind, h, substep, iteration > 0);
            forConstraints(kKind);
            if constexpr (Bodies::kRotate && kRelaxes) relaxRolling(step, group);
            resetLocked();
        }
    }

    /// Substepped soft constraints (TGS soft): many small steps converge better than many iterations, and the
    /// relax pass removes the velocity that only corrected overlap. Normals and arms of contacts are constant
    /// in a step, so the same impulses change a body's velocity equally in each substep: from the second
    /// substep on, warm starting is a single sum per body (accelerate). Sources: M. Macklin et al., "Small
    /// Steps in Physics Simulation", SCA 2019; E. Catto, "Solver2D", 2024.
    void run() {
        auto move = kernels.move;
        // Kinematic bodies may rotate even if no dynamic body can.
        if constexpr (Bodies::kRotate) {
            if (!step.runs(Effect::Rotation) && !step.runs(Effect::Kinematics))
                move = solverKernels().moveWithoutRotation;
        }
        const bool isDriven = !step.work.smooth.driven.empty();
        for (int i = 0; i < group.substeps; ++i) {
            const float elapsed = h * static_cast<float>(i);
            if (isDriven) driveBodies(step, group, h, elapsed);
            forBodies(step, group,
                      [&](int begin, int end) { kernels.accelerate(bodies, h, i == 0, begin, end); });
            if (i == 0) forConstraints(PassKind::WarmStart);
            if constexpr (Bodies::kRotate)
                if (i == 0) warmStartRolling(step, group);
            forSoft([&](const SoftGroup& soft) { springSoft(step, soft, h, i); });
            resetLocked();
            contacts.fixed.pass.elapsed = elapsed;
            iterate<PassKind::Push>(i);
            forBodies(step, group, [&](int begin, int end) { move(bodies, h, begin, end); });
            forSoft([&](const SoftGroup& soft) { closeSoft(step, soft, h); });
            iterate<PassKind::Relax>(i);
            if constexpr (Bodies::kRotate) {
                noteLargestImpulses(step, group);
                noteJointForces(step, group, 1.0f / h);
            }
            addImpulses(step.work);
        }
        if (isDriven) finishDriving(step, group);
        if constexpr (Bodies::kRotate) {
            forSoft([&](const SoftGroup& soft) { finishSoft(step, soft, h); });
            applyRestitution(step, group);
            finishImpulseSums(step.work);
            resetLocked();
        }
    }
};

/// Solves the groups with rotation (SolverBodies), or those without (BodiesWithoutRotation).
template <class Bodies>
void solveGroups(StepContext& step, const GroupKernels<Bodies>& kernels, const Bodies& bodies) {
    const Settings& settings = step.world.settings;
    ContactSets<Bodies> contacts = contactsOf(step, kernels);
    for (const SolveGroup& group : step.work.groups) {
        if (group.withoutRotation == Bodies::kRotate) continue;
        const float h = step.dt / static_cast<float>(group.substeps);
        contacts.two.pass = contacts.fixed.pass = contactPass(settings, h);
        startImpulseSums(step, group);
        Solver<Bodies> solver{step, kernels, group, bodies, contacts, {}, h, int{settings.iterations}, false};
        if constexpr (Bodies::kRotate) {
            solver.joints = jointPass(settings, h);
            solver.hasTrees = solvesTrees(step.world, step.work);
        }
        solver.run();
    }
    contacts.two.store(step);
    contacts.fixed.store(step);
}

SolverBodies bodiesOf(Workspace& work) {
    return {work.velocity.data(),       work.deltaPosition.data(),
            work.drive.data(),          work.keep.empty() ? nullptr : work.keep.data(),
            work.ballisticDrift.data(), work.velocityBeforeImpulses.data()};
}

void solveWithRotation(StepContext& step) {
    Workspace& work = step.work;
    prepareRestitution(step);
    prepareRolling(step);
    if (step.runs(Effect::SoftBodies)) {
        for (SoftObstacle& near : work.softSurroundings.obstacles) near.slot = work.slots[near.body];
        work.softSurroundings.obstacleOf.clear();
    }
    solveGroups(step, solverKernels().rotating, bodiesOf(work));
    storeRolling(step);
    if (step.runs(Effect::Joints)) storeJoints(step);
}

/// Stops bodies that a load presses into a static body before their cores pass its surface: the springs of
/// contacts yield in proportion to the ratio of the load to the mass.
void holdPressedBodies(StepContext& step) {
    Workspace& work = step.work;
    const Bodies& bodies = step.world.bodies;
    for (std::size_t i = 0; i < work.contactKeys.size(); ++i) {
        const Contact& contact = step.world.contacts[i];
        const float starts[] = {contact.separation0, contact.separation1};
        if (!pushes(work.contactKeys[i]) || std::min(starts[0], starts[1]) >= 0.0f) continue;
        const BodyInfo& info = bodies.info[contact.bodyB];
        const std::int32_t slot = work.slots[contact.bodyB];
        if (slot < 0 || bodies.info[contact.bodyA].kind != BodyKind::Static) continue;
        Float4& moved = work.deltaPosition[static_cast<std::size_t>(slot)];
        const Vec2 normal = contact.normal, shift{moved.x, moved.y};
        // Anchors belong to the rotations for which the points were computed.
        const Rot rotationA{dot(contact.normalInA, normal), cross(contact.normalInA, normal)};
        float outward = 0.0f;
        for (int p = 0; p < contact.count; ++p) {
            const Vec2 arm = rotate(rotationA * contact.relativeRotation, contact.anchors[p].b);
            const float end = starts[p] + dot(shift + moved.z * perpendicular(arm) + moved.w * arm, normal) +
                              moved.w * contact.roundB;
            outward = std::max(outward, std::min(starts[p], -kSweptCore * info.core) - end);
        }
        if (!(outward > 0.0f)) continue;
        if ((info.flags & kLockX) == 0) moved.x += outward * normal.x;
        if ((info.flags & kLockY) == 0) moved.y += outward * normal.y;
    }
}

/// Rotates kinematic bodies in a step in which no dynamic body can rotate.
void turnBodies(StepContext& step) {
    const SolverBodies bodies = bodiesOf(step.work);
    for (const SolveGroup& group : step.work.groups) {
        const float h = step.dt / static_cast<float>(group.substeps);
        for (int i = 0; i < group.substeps; ++i) {
            forBodies(step, group,
                      [&](int begin, int end) { solverKernels().rotating.move(bodies, h, begin, end); });
        }
    }
}

void solveWithoutRotation(StepContext& step) {
    Workspace& work = step.work;
    const auto first = std::find_if(work.groups.begin(), work.groups.end(),
                                    [](const SolveGroup& group) { return group.withoutRotation; });
    const auto begin = static_cast<std::size_t>(first->begin);
    std::vector<Float4>& states = work.statesWithoutRotation;
    states.resize(work.velocity.size());
    for (std::size_t i = begin; i < states.size(); ++i)
        states[i] = {work.velocity[i].x, work.velocity[i].y, 0.0f, 0.0f};
    const SolverBodies all = bodiesOf(work);
    const BodiesWithoutRotation bodies{states.data(), all.drive, all.keep, all.ballisticDrift,
                                       all.velocityBeforeImpulses};
    solveGroups(step, solverKernels().withoutRotation, bodies);
    if (step.isWithoutRotation() && step.runs(Effect::Kinematics)) turnBodies(step);
    for (std::size_t i = begin; i < states.size(); ++i) {
        work.velocity[i].x = states[i].x, work.velocity[i].y = states[i].y;
        work.deltaPosition[i].x = states[i].z, work.deltaPosition[i].y = states[i].w;
    }
}

}  // namespace

void solve(StepContext& step) {
    clearImpulseSums(step);
    prepareLocks(step);
    const std::vector<SolveGroup>& groups = step.work.groups;
    if (groups.empty() || !groups.front().withoutRotation) solveWithRotation(step);
    if (!groups.empty() && groups.back().withoutRotation) solveWithoutRotation(step);
    if (step.runs(Effect::Contacts)) holdPressedBodies(step);
}

}  // namespace plumb::physics
