#include <algorithm>

#include "physics/solver/grow_trees.hpp"
#include "physics/solver/joint_lanes.hpp"
#include "physics/solver/locks.hpp"
#include "physics/solver/passes.hpp"
#include "physics/solver/restitution.hpp"
#include "physics/solver/rolling.hpp"
#include "physics/solver/solve_plain.hpp"
#include "physics/solver/solve_trees.hpp"
#include "physics/stages.hpp"

namespace plumb::physics {

namespace {

/// One group, while its substeps are done.
struct Solver {
    StepContext& step;
    Workspace& work;
    const SolverKernels& kernels;
    const ContactKernels<ContactBlock>& two;
    const ContactKernels<FixedContactBlock>& fixed;
    const SolveGroup& group;
    SolverBodies bodies;
    ContactPass contacts;       // between bodies that can be pushed
    ContactPass fixedContacts;  // stiffer: the ground does not give way
    JointPass joints;
    float h;         // s
    int iterations;  // of each substep
    bool hasTrees;
};

SolverBodies bodiesOf(Workspace& work) {
    return {work.velocity.data(), work.shift.data(),
            work.drive.data(),    work.keep.empty() ? nullptr : work.keep.data(),
            work.flight.data(),   work.undisturbed.data()};
}

/// Runs one pass over all constraints of a group, colour by colour: joints, then contacts.
template <class Two, class Fixed>
void forConstraints(Solver& solver, JointAct act, Two&& two, Fixed&& fixed) {
    forColours(solver.group.contactColours | solver.group.jointColours, [&](int c, int grain) {
        const ColourBlocks& blocks = solver.group.colours[c];
        solveJoints(solver.step, solver.bodies, solver.joints, solver.group, c, act);
        forRange(solver.step, blocks.contactBegin, blocks.contactEnd, grain, two);
        forRange(solver.step, blocks.fixedBegin, blocks.fixedEnd, grain, fixed);
    });
}

void warmStart(Solver& solver) {
    Workspace& work = solver.work;
    forConstraints(
        solver, JointAct::WarmStart,
        [&](int begin, int end) {
            solver.two.warmStart(solver.bodies, work.contactLanes.data(), work.contactBlocks.data(), begin,
                                 end);
        },
        [&](int begin, int end) {
            solver.fixed.warmStart(solver.bodies, work.fixedLanes.data(), work.fixedBlocks.data(), begin,
                                   end);
        });
}

void push(Solver& solver) {
    Workspace& work = solver.work;
    forConstraints(
        solver, JointAct::Push,
        [&](int begin, int end) {
            solver.two.push(solver.bodies, solver.contacts, work.contactLanes.data(),
                            work.contactBlocks.data(), begin, end);
        },
        [&](int begin, int end) {
            solver.fixed.push(solver.bodies, solver.fixedContacts, work.fixedLanes.data(),
                              work.fixedBlocks.data(), begin, end);
        });
}

void relax(Solver& solver) {
    Workspace& work = solver.work;
    forConstraints(
        solver, JointAct::Relax,
        [&](int begin, int end) {
            solver.two.relax(solver.bodies, solver.contacts, work.contactLanes.data(),
                             work.contactBlocks.data(), begin, end);
        },
        [&](int begin, int end) {
            solver.fixed.relax(solver.bodies, solver.fixedContacts, work.fixedLanes.data(),
                               work.fixedBlocks.data(), begin, end);
        });
}

/// Velocities that keep constraints, and close what is open of them.
void pushOften(Solver& solver, int substep) {
    for (int turn = 0; turn < solver.iterations; ++turn) {
        if (solver.hasTrees) pushTrees(solver.step, solver.group, solver.h, substep, turn > 0);
        push(solver);
        lockAxes(solver.step, solver.group, solver.work.velocity);
    }
}

/// The same without what only closed.
void relaxOften(Solver& solver, int substep) {
    for (int turn = 0; turn < solver.iterations; ++turn) {
        if (solver.hasTrees) relaxTrees(solver.step, solver.group, solver.h, substep, turn > 0);
        relax(solver);
        relaxRolling(solver.step, solver.group);
        lockAxes(solver.step, solver.group, solver.work.velocity);
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
        lockAxes(solver.step, solver.group, solver.work.velocity);
        solver.fixedContacts.elapsed = solver.h * static_cast<float>(i);
        pushOften(solver, i);
        forBodies(solver.step, solver.group,
                  [&](int begin, int end) { move(solver.bodies, solver.h, begin, end); });
        relaxOften(solver, i);
        noteLargestImpulses(solver.step, solver.group);
        noteJointForces(solver.step, solver.group, 1.0f / solver.h);
    }
    applyRestitution(solver.step, solver.group);
    lockAxes(solver.step, solver.group, solver.work.velocity);
}

}  // namespace

void solve(StepContext& step) {
    if (step.isPlain()) return solvePlain(step);
    const SolverKernels& kernels = solverKernels();
    const std::size_t rubs = step.runs(Effect::Friction) ? 1 : 0;
    Workspace& work = step.work;
    prepareRestitution(step);
    prepareRolling(step);
    prepareLocks(step);
    for (const SolveGroup& group : work.groups) {
        const float h = step.dt / static_cast<float>(group.substeps);
        Solver solver{step,
                      work,
                      kernels,
                      kernels.contacts[rubs],
                      kernels.fixedContacts[rubs],
                      group,
                      bodiesOf(work),
                      contactPass(step.world.settings, h, 1.0f),
                      contactPass(step.world.settings, h, 2.0f),
                      jointPass(step.world.settings, h),
                      h,
                      std::clamp<int>(step.world.settings.iterations, 1, kMostIterations),
                      solvesTrees(step.world, work)};
        solveGroup(solver);
    }
    storeImpulses(step, kernels.contacts[rubs], work.contactLanes, work.contactBlocks);
    storeImpulses(step, kernels.fixedContacts[rubs], work.fixedLanes, work.fixedBlocks);
    storeRolling(step);
    if (step.runs(Effect::Joints)) storeJoints(step);
}

}  // namespace plumb::physics
