#include <algorithm>
#include <bit>

#include "physics/solver/grow_trees.hpp"
#include "physics/solver/joint_lanes.hpp"
#include "physics/solver/locks.hpp"
#include "physics/solver/restitution.hpp"
#include "physics/solver/rolling.hpp"
#include "physics/solver/softness.hpp"
#include "physics/solver/solve_trees.hpp"
#include "physics/stages.hpp"

namespace plumb::physics {

namespace {

constexpr int kBlockGrain = 24;
constexpr int kBodyGrain = 1024;
constexpr int kMostIterations = 64;

/// One group, while its substeps are done.
struct Solver {
    StepContext& step;
    Workspace& work;
    const SolverKernels& kernels;
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

ContactPass passOf(const Settings& settings, float h, float stiffness) {
    ContactPass pass;
    pass.substepRate = 1.0f / h;
    pass.softness = softness(stiffness * settings.contactStiffness / h, settings.contactDampingRatio, h);
    pass.pushSpeed = settings.pushSpeed;
    pass.deepPushRate = settings.deepPushRate;
    return pass;
}

template <class Pass>
void forBodies(Solver& solver, Pass&& pass) {
    const int begin = solver.group.begin;
    forPieces(solver.step, solver.group.end - begin, kBodyGrain,
              [&](int first, int last, int) { pass(begin + first, begin + last); });
}

/// Runs one pass over all constraints of a group, colour by colour: joints, then contacts.
template <class Two, class Fixed>
void forConstraints(Solver& solver, JointAct act, Two&& two, Fixed&& fixed) {
    const auto colour = [&](int c, int grain) {
        const ColourBlocks& blocks = solver.group.colours[c];
        solveJoints(solver.step, solver.bodies, solver.joints, solver.group, c, act);
        forPieces(solver.step, blocks.contactEnd - blocks.contactBegin, grain, [&](int first, int last, int) {
            two(blocks.contactBegin + first, blocks.contactBegin + last);
        });
        forPieces(solver.step, blocks.fixedEnd - blocks.fixedBegin, grain, [&](int first, int last, int) {
            fixed(blocks.fixedBegin + first, blocks.fixedBegin + last);
        });
    };
    const std::uint64_t used = solver.group.contactColours | solver.group.jointColours;
    if ((used >> kOverflow & 1) != 0) colour(kOverflow, 1 << 30);  // they share bodies: one after the other
    for (std::uint64_t rest = used & ((std::uint64_t{1} << kColours) - 1); rest != 0; rest &= rest - 1)
        colour(std::countr_zero(rest), kBlockGrain);
}

void warmStart(Solver& solver) {
    Workspace& work = solver.work;
    forConstraints(
        solver, JointAct::WarmStart,
        [&](int begin, int end) {
            solver.kernels.warmStart(solver.bodies, work.contactLanes.data(), work.contactBlocks.data(),
                                     begin, end);
        },
        [&](int begin, int end) {
            solver.kernels.warmStartFixed(solver.bodies, work.fixedLanes.data(), work.fixedBlocks.data(),
                                          begin, end);
        });
}

void push(Solver& solver) {
    Workspace& work = solver.work;
    forConstraints(
        solver, JointAct::Push,
        [&](int begin, int end) {
            solver.kernels.push(solver.bodies, solver.contacts, work.contactLanes.data(),
                                work.contactBlocks.data(), begin, end);
        },
        [&](int begin, int end) {
            solver.kernels.pushFixed(solver.bodies, solver.fixedContacts, work.fixedLanes.data(),
                                     work.fixedBlocks.data(), begin, end);
        });
}

void relax(Solver& solver) {
    Workspace& work = solver.work;
    forConstraints(
        solver, JointAct::Relax,
        [&](int begin, int end) {
            solver.kernels.relax(solver.bodies, solver.contacts, work.contactLanes.data(),
                                 work.contactBlocks.data(), begin, end);
        },
        [&](int begin, int end) {
            solver.kernels.relaxFixed(solver.bodies, solver.fixedContacts, work.fixedLanes.data(),
                                      work.fixedBlocks.data(), begin, end);
        });
}

void storeImpulses(StepContext& step, const SolverKernels& kernels) {
    Workspace& work = step.work;
    auto* contacts = reinterpret_cast<Float4*>(step.world.contacts.data());
    forPieces(step, static_cast<int>(work.contactBlocks.size()), kBlockGrain, [&](int begin, int end, int) {
        kernels.store(contacts, work.contactLanes.data(), work.contactBlocks.data(), begin, end);
    });
    forPieces(step, static_cast<int>(work.fixedBlocks.size()), kBlockGrain, [&](int begin, int end, int) {
        kernels.storeFixed(contacts, work.fixedLanes.data(), work.fixedBlocks.data(), begin, end);
    });
}

/// Velocities that keep constraints, and close what is open of them.
void pushOften(Solver& solver, int substep) {
    for (int turn = 0; turn < solver.iterations; ++turn) {
        if (solver.hasTrees) pushTrees(solver.step, solver.group, solver.h, substep, turn > 0);
        push(solver);
        lockAxes(solver.step, solver.group);
    }
}

/// The same without what only closed.
void relaxOften(Solver& solver, int substep) {
    for (int turn = 0; turn < solver.iterations; ++turn) {
        if (solver.hasTrees) relaxTrees(solver.step, solver.group, solver.h, substep, turn > 0);
        relax(solver);
        relaxRolling(solver.step, solver.group);
        lockAxes(solver.step, solver.group);
    }
}

/// Sub-stepped soft constraints: many small steps beat many iterations, and the relax pass takes back the
/// velocity that only served to push bodies apart. Directions and arms are those of the start of the step, so
/// what all impulses of a substep did to a body's velocity is the same in the next one: from the second
/// substep on, warm starting is one sum for each body (accelerate) and no pass over constraints. Sources: M.
/// Macklin et al., "Small Steps in Physics Simulation", SCA 2019; E. Catto, "Solver2D", 2024.
void solveGroup(Solver& solver) {
    for (int i = 0; i < solver.group.substeps; ++i) {
        forBodies(solver, [&](int begin, int end) {
            solver.kernels.accelerate(solver.bodies, solver.h, i == 0, begin, end);
        });
        if (i == 0) {
            warmStart(solver);
            warmStartRolling(solver.step, solver.group);
        }
        lockAxes(solver.step, solver.group);
        solver.fixedContacts.elapsed = solver.h * static_cast<float>(i);
        pushOften(solver, i);
        forBodies(solver,
                  [&](int begin, int end) { solver.kernels.move(solver.bodies, solver.h, begin, end); });
        relaxOften(solver, i);
        noteLargestImpulses(solver.step, solver.group);
        noteJointForces(solver.step, solver.group, 1.0f / solver.h);
    }
    applyRestitution(solver.step, solver.group);
    lockAxes(solver.step, solver.group);
}

}  // namespace

void solve(StepContext& step) {
    const SolverKernels& kernels = solverKernels();
    prepareRestitution(step);
    prepareRolling(step);
    prepareLocks(step);
    for (const SolveGroup& group : step.work.groups) {
        const float h = step.dt / static_cast<float>(group.substeps);
        Solver solver{step,
                      step.work,
                      kernels,
                      group,
                      bodiesOf(step.work),
                      passOf(step.world.settings, h, 1.0f),
                      passOf(step.world.settings, h, 2.0f),
                      jointPass(step.world.settings, h),
                      h,
                      std::clamp<int>(step.world.settings.iterations, 1, kMostIterations),
                      solvesTrees(step.world, step.work)};
        solveGroup(solver);
    }
    storeImpulses(step, kernels);
    storeRolling(step);
    if (step.world.manifest.runs(Effect::Joints)) storeJoints(step);
}

}  // namespace plumb::physics
