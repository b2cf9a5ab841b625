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

/// State of a group while its substeps are solved.
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
};

/// Calls act(soft group) for the soft groups that push bodies of the solver's group.
template <class Solver, class Act>
void forSoft(const Solver& solver, Act&& act) {
    if (!solver.step.runs(Effect::SoftBodies)) return;
    for (const SoftGroup& soft : solver.step.work.softSurroundings.groups) {
        const std::int32_t slot = soft.body == kNone ? -1 : solver.step.work.slots[soft.body];
        if (slot >= solver.group.begin && slot < solver.group.end) act(soft);
    }
}

/// Performs one pass over all constraints of a group, color by color: joints, then contacts.
template <class Bodies>
void forConstraints(Solver<Bodies>& solver, PassKind kind) {
    forColours(solver.group.contactColours | solver.group.jointColours, [&](int colour, int grain) {
        if constexpr (Bodies::kRotate)
            solveJoints(solver.step, solver.bodies, solver.joints, solver.group, colour, kind);
        if ((solver.group.contactColours >> colour & 1) == 0) return;
        const ContactRanges& ranges = solver.group.colours[colour].contacts;
        solver.contacts.two.run(solver.step, solver.bodies, ranges.two, grain, kind);
        solver.contacts.fixed.run(solver.step, solver.bodies, ranges.fixed, grain, kind);
    });
}

template <class Bodies>
void lock(Solver<Bodies>& solver) {
    if (!solver.step.runs(Effect::Locks)) return;
    for (const AxisLock& held : solver.step.work.locks) {
        const auto slot = static_cast<std::int32_t>(held.slot);
        if (slot >= solver.group.begin && slot < solver.group.end)
            lock(solver.bodies.velocity[slot], held.flags);
    }
}

/// Computes velocities that satisfy the constraints; the biased pass also corrects position errors.
template <PassKind kKind, class Bodies>
void iterate(Solver<Bodies>& solver, int substep) {
    constexpr bool kRelaxes = kKind == PassKind::Relax;
    for (int iteration = 0; iteration < solver.iterations; ++iteration) {
        solver.joints.first = iteration == 0;
        if constexpr (Bodies::kRotate) {
            forSoft(solver, [&](const SoftGroup& soft) {
                solveSoft(solver.step, soft, solver.contacts.two.pass, kRelaxes);
            });
        }
        if (solver.hasTrees) solveTrees(solver.step, solver.group, kKind, solver.h, substep, iteration > 0);
        forConstraints(solver, kKind);
        if constexpr (Bodies::kRotate && kRelaxes) relaxRolling(solver.step, solver.group);
        lock(solver);
    }
}

/// Substepped soft constraints (TGS soft): many small steps converge better than many iterations, and the
/// relax pass removes the velocity that only corrected overlap. Normals and arms of contacts are constant in
/// a step, so the same impulses change a body's velocity equally in each substep: from the second substep on,
/// warm starting is a single sum per body (accelerate). Groups without rotation have no joints, soft bodies
/// or restitution. Sources: M. Macklin et al., "Small Steps in Physics Simulation", SCA 2019; E. Catto,
/// "Solver2D", 2024.
template <class Bodies>
void solveGroup(Solver<Bodies>& solver) {
    auto move = solver.kernels.move;
    // Kinematic bodies may rotate even if no dynamic body can.
    if constexpr (Bodies::kRotate) {
        if (!solver.step.runs(Effect::Rotation) && !solver.step.runs(Effect::Kinematics))
            move = solverKernels().moveWithoutRotation;
    }
    const bool isDriven = !solver.step.work.smooth.driven.empty();
    for (int i = 0; i < solver.group.substeps; ++i) {
        if (isDriven) driveBodies(solver.step, solver.group, solver.h, solver.h * static_cast<float>(i));
        forBodies(solver.step, solver.group, [&](int begin, int end) {
            solver.kernels.accelerate(solver.bodies, solver.h, i == 0, begin, end);
        });
        if (i == 0) forConstraints(solver, PassKind::WarmStart);
        if constexpr (Bodies::kRotate) {
            if (i == 0) warmStartRolling(solver.step, solver.group);
            forSoft(solver, [&](const SoftGroup& soft) { springSoft(solver.step, soft, solver.h, i); });
        }
        lock(solver);
        solver.contacts.fixed.pass.elapsed = solver.h * static_cast<float>(i);
        iterate<PassKind::Push>(solver, i);
        forBodies(solver.step, solver.group,
                  [&](int begin, int end) { move(solver.bodies, solver.h, begin, end); });
        if constexpr (Bodies::kRotate)
            forSoft(solver, [&](const SoftGroup& soft) { closeSoft(solver.step, soft, solver.h); });
        iterate<PassKind::Relax>(solver, i);
        if constexpr (Bodies::kRotate) {
            noteLargestImpulses(solver.step, solver.group);
            noteJointForces(solver.step, solver.group, 1.0f / solver.h);
        }
        addImpulses(solver.step.work);
    }
    if (isDriven) finishDriving(solver.step, solver.group);
    if constexpr (Bodies::kRotate) {
        forSoft(solver, [&](const SoftGroup& soft) { finishSoft(solver.step, soft, solver.h); });
        applyRestitution(solver.step, solver.group);
        finishImpulseSums(solver.step.work);
        lock(solver);
    }
}

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
        solveGroup(solver);
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
        for (SoftObstacle& obstacle : work.softSurroundings.obstacles)
            obstacle.slot = work.slots[obstacle.body];
        work.softSurroundings.obstacleOf.clear();
    }
    solveGroups(step, solverKernels().rotating, bodiesOf(work));
    storeRolling(step);
    if (step.runs(Effect::Joints)) storeJoints(step);
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
}

}  // namespace plumb::physics
