#include <algorithm>

#include "physics/solver/joint_lanes.hpp"
#include "physics/solver/locks.hpp"
#include "physics/solver/passes.hpp"
#include "physics/solver/restitution.hpp"
#include "physics/solver/rolling.hpp"
#include "physics/solver/solve_without_rotation.hpp"
#include "physics/solver/step_impulses.hpp"
#include "physics/stages.hpp"
#include "physics/trees/joint_tree_builder.hpp"
#include "physics/trees/joint_tree_solver.hpp"

namespace plumb::physics {

namespace {

using Contacts =
    ContactSets<ContactSet<ContactBlock, SolverBodies>, ContactSet<FixedContactBlock, SolverBodies>>;

/// One group, while its substeps are done.
struct Solver {
    StepContext& step;
    const SolverKernels& kernels;
    const SolveGroup& group;
    SolverBodies bodies;
    Contacts& contacts;
    JointPass joints;
    float h;         // s
    int iterations;  // of each substep
    bool hasTrees;
};

/// Calls act(soft group) with those of which bodies are in the group that is solved.
template <class Act>
void forSoft(const Solver& solver, Act&& act) {
    if (!solver.step.runs(Effect::SoftBodies)) return;
    for (const SoftGroup& soft : solver.step.work.softSurroundings.groups) {
        const std::int32_t slot = soft.body == kNone ? -1 : solver.step.work.slots[soft.body];
        if (slot >= solver.group.begin && slot < solver.group.end) act(soft);
    }
}

void solveSoft(const Solver& solver, bool relax) {
    forSoft(solver,
            [&](const SoftGroup& soft) { solveSoft(solver.step, soft, solver.contacts.two.pass, relax); });
}

SolverBodies bodiesOf(Workspace& work) {
    return {work.velocity.data(),       work.deltaPosition.data(),
            work.drive.data(),          work.keep.empty() ? nullptr : work.keep.data(),
            work.ballisticDrift.data(), work.velocityBeforeImpulses.data()};
}

/// Runs one pass over all constraints of a group, colour by colour: joints, then contacts.
template <class Act>
void forConstraints(Solver& solver, JointAct joints, Act&& act) {
    forColours(solver.group.contactColours | solver.group.jointColours, [&](int colour, int grain) {
        solveJoints(solver.step, solver.bodies, solver.joints, solver.group, colour, joints);
        solver.contacts.forBlocks(solver.step, solver.group.colours[colour], grain, act);
    });
}

void warmStart(Solver& solver) {
    forConstraints(solver, JointAct::WarmStart, [&](const auto& contacts, int begin, int end) {
        contacts.warmStart(solver.bodies, begin, end);
    });
}

void push(Solver& solver) {
    forConstraints(solver, JointAct::Push, [&](const auto& contacts, int begin, int end) {
        contacts.push(solver.bodies, begin, end);
    });
}

void relax(Solver& solver) {
    forConstraints(solver, JointAct::Relax, [&](const auto& contacts, int begin, int end) {
        contacts.relax(solver.bodies, begin, end);
    });
}

/// Velocities that keep constraints, and close what is open of them.
void pushOften(Solver& solver, int substep) {
    for (int turn = 0; turn < solver.iterations; ++turn) {
        solver.joints.first = turn == 0;
        solveSoft(solver, false);
        if (solver.hasTrees) pushTrees(solver.step, solver.group, solver.h, substep, turn > 0);
        push(solver);
        lockAxes(solver.step, solver.group, solver.step.work.velocity);
    }
}

/// The same without what only closed.
void relaxOften(Solver& solver, int substep) {
    for (int turn = 0; turn < solver.iterations; ++turn) {
        solver.joints.first = turn == 0;
        solveSoft(solver, true);
        if (solver.hasTrees) relaxTrees(solver.step, solver.group, solver.h, substep, turn > 0);
        relax(solver);
        relaxRolling(solver.step, solver.group);
        lockAxes(solver.step, solver.group, solver.step.work.velocity);
    }
}

/// Sub-stepped soft constraints: many small steps beat many iterations, and the relax pass takes back the
/// velocity that only served to push bodies apart. Directions and arms are those of the start of the step, so
/// what all impulses of a substep did to a body's velocity is the same in the next one: from the second
/// substep on, warm starting is one sum for each body (accelerate) and no pass over constraints. Sources: M.
/// Macklin et al., "Small Steps in Physics Simulation", SCA 2019; E. Catto, "Solver2D", 2024.
void solveGroup(Solver& solver) {
    // A kinematic body turns though nobody is turned.
    const bool turns = solver.step.runs(Effect::Rotation) || solver.step.runs(Effect::Kinematics);
    const auto move = turns ? solver.kernels.move : solver.kernels.moveUnturned;
    for (int i = 0; i < solver.group.substeps; ++i) {
        forBodies(solver.step, solver.group, [&](int begin, int end) {
            solver.kernels.accelerate(solver.bodies, solver.h, i == 0, begin, end);
        });
        if (i == 0) {
            warmStart(solver);
            warmStartRolling(solver.step, solver.group);
        }
        forSoft(solver, [&](const SoftGroup& soft) { springSoft(solver.step, soft, solver.h, i); });
        lockAxes(solver.step, solver.group, solver.step.work.velocity);
        solver.contacts.fixed.pass.elapsed = solver.h * static_cast<float>(i);
        pushOften(solver, i);
        forBodies(solver.step, solver.group,
                  [&](int begin, int end) { move(solver.bodies, solver.h, begin, end); });
        forSoft(solver, [&](const SoftGroup& soft) { closeSoft(solver.step, soft, solver.h); });
        relaxOften(solver, i);
        noteLargestImpulses(solver.step, solver.group);
        addImpulses(solver.step.work);
        noteJointForces(solver.step, solver.group, 1.0f / solver.h);
    }
    forSoft(solver, [&](const SoftGroup& soft) { storeSoftContacts(solver.step, soft, solver.h); });
    applyRestitution(solver.step, solver.group);
    finishImpulseSums(solver.step.work);
    lockAxes(solver.step, solver.group, solver.step.work.velocity);
}

void solveWithRotation(StepContext& step) {
    const SolverKernels& kernels = solverKernels();
    const std::size_t hasFriction = step.runs(Effect::Friction) ? 1 : 0;
    Workspace& work = step.work;
    const Settings& settings = step.world.settings;
    prepareRestitution(step);
    prepareRolling(step);
    if (step.runs(Effect::SoftBodies)) {
        for (SoftObstacle& obstacle : work.softSurroundings.obstacles)
            obstacle.slot = work.slots[obstacle.body];
        work.softSurroundings.obstacleOf.clear();
    }
    Contacts contacts{{kernels.contacts[hasFriction], work.contactLanes, work.contactBlocks},
                      {kernels.fixedContacts[hasFriction], work.fixedLanes, work.fixedBlocks}};
    for (const SolveGroup& group : work.groups) {
        if (group.withoutRotation) break;
        const float h = step.dt / static_cast<float>(group.substeps);
        contacts.startGroup(settings, h);
        startImpulseSums(step, group);
        Solver solver{step,
                      kernels,
                      group,
                      bodiesOf(work),
                      contacts,
                      jointPass(settings, h),
                      h,
                      int{settings.iterations},
                      solvesTrees(step.world, work)};
        solveGroup(solver);
    }
    contacts.store(step);
    storeRolling(step);
    if (step.runs(Effect::Joints)) storeJoints(step);
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
