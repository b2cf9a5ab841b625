#include "physics/solver/solve_without_rotation.hpp"

#include <algorithm>

#include "physics/solver/locks.hpp"
#include "physics/solver/passes.hpp"
#include "physics/solver/step_impulses.hpp"

namespace plumb::physics {

namespace {

using Contacts = ContactSets<ContactSet<BlockWithoutRotation, BodiesWithoutRotation>,
                             ContactSet<FixedBlockWithoutRotation, BodiesWithoutRotation>>;

/// One group, while its substeps are solved.
struct Solver {
    StepContext& step;
    const SolverKernels& kernels;
    const SolveGroup& group;
    BodiesWithoutRotation bodies;
    Contacts& contacts;
    float h;         // s
    int iterations;  // of each substep
};

BodiesWithoutRotation bodiesOf(Workspace& work) {
    return {work.statesWithoutRotation.data(), work.drive.data(),
            work.keep.empty() ? nullptr : work.keep.data(), work.ballisticDrift.data(),
            work.velocityBeforeImpulses.data()};
}

/// Runs `act(contacts, begin, end)` over the blocks of all colors.
template <class Act>
void forContacts(Solver& solver, Act&& act) {
    forColours(solver.group.contactColours, [&](int colour, int grain) {
        solver.contacts.forBlocks(solver.step, solver.group.colours[colour], grain, act);
    });
}

void lock(Solver& solver) { lockAxes(solver.step, solver.group, solver.step.work.statesWithoutRotation); }

/// The same, once per iteration.
template <class Act>
void iterate(Solver& solver, Act&& act) {
    for (int i = 0; i < solver.iterations; ++i) {
        forContacts(solver, act);
        lock(solver);
    }
}

void solveGroup(Solver& solver) {
    const BodiesWithoutRotation& bodies = solver.bodies;
    for (int i = 0; i < solver.group.substeps; ++i) {
        forBodies(solver.step, solver.group, [&](int begin, int end) {
            solver.kernels.acceleratePlain(bodies, solver.h, i == 0, begin, end);
        });
        if (i == 0) {
            forContacts(solver, [&](const auto& contacts, int begin, int end) {
                contacts.warmStart(bodies, begin, end);
            });
        }
        lock(solver);
        solver.contacts.fixed.pass.elapsed = solver.h * static_cast<float>(i);
        iterate(solver, [&](const auto& contacts, int begin, int end) { contacts.push(bodies, begin, end); });
        forBodies(solver.step, solver.group,
                  [&](int begin, int end) { solver.kernels.movePlain(bodies, begin, end); });
        iterate(solver,
                [&](const auto& contacts, int begin, int end) { contacts.relax(bodies, begin, end); });
        addImpulses(solver.step.work);
    }
}

void gatherStates(Workspace& work, std::size_t begin) {
    work.statesWithoutRotation.resize(work.velocity.size());
    for (std::size_t i = begin; i < work.velocity.size(); ++i)
        work.statesWithoutRotation[i] = {work.velocity[i].x, work.velocity[i].y, 0.0f, 0.0f};
}

/// A kinematic body may rotate by its own velocity in a step in which no impulse rotates a body.
void turnBodies(Solver& solver) {
    Workspace& work = solver.step.work;
    const SolverBodies bodies{work.velocity.data(),
                              work.deltaPosition.data(),
                              nullptr,
                              nullptr,
                              work.ballisticDrift.data(),
                              nullptr};
    for (int i = 0; i < solver.group.substeps; ++i) {
        forBodies(solver.step, solver.group,
                  [&](int begin, int end) { solver.kernels.move(bodies, solver.h, begin, end); });
    }
}

void giveBack(Workspace& work, std::size_t begin) {
    for (std::size_t i = begin; i < work.velocity.size(); ++i) {
        const Float4& state = work.statesWithoutRotation[i];
        work.velocity[i].x = state.x, work.velocity[i].y = state.y;
        work.deltaPosition[i].x = state.z, work.deltaPosition[i].y = state.w;
    }
}

}  // namespace

void solveWithoutRotation(StepContext& step) {
    Workspace& work = step.work;
    const Settings& settings = step.world.settings;
    const SolverKernels& kernels = solverKernels();
    const std::size_t hasFriction = step.runs(Effect::Friction) ? 1 : 0;
    const auto first = std::find_if(work.groups.begin(), work.groups.end(),
                                    [](const SolveGroup& group) { return group.withoutRotation; });
    const auto firstSlot = static_cast<std::size_t>(first->begin);
    gatherStates(work, firstSlot);
    const auto [begin, beginFixed] = blocksWithRotation(work);
    Contacts contacts{
        {kernels.plain[hasFriction], work.contactLanes, work.blocksWithoutRotation, begin},
        {kernels.plainFixed[hasFriction], work.fixedLanes, work.fixedBlocksWithoutRotation, beginFixed}};
    for (auto place = first; place != work.groups.end(); ++place) {
        const SolveGroup& group = *place;
        const float h = step.dt / static_cast<float>(group.substeps);
        contacts.startGroup(settings, h);
        startImpulseSums(step, group);
        Solver solver{step, kernels, group, bodiesOf(work), contacts, h, settings.iterations};
        solveGroup(solver);
        if (step.isWithoutRotation() && step.runs(Effect::Kinematics)) turnBodies(solver);
    }
    giveBack(work, firstSlot);
    contacts.store(step);
}

}  // namespace plumb::physics
