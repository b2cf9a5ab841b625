#include "physics/solver/solve_plain.hpp"

#include <algorithm>

#include "physics/solver/locks.hpp"
#include "physics/solver/passes.hpp"

namespace plumb::physics {

namespace {

template <class Block>
struct Contacts {
    const ContactKernels<Block, PlainBodies>& kernels;
    const std::vector<BlockLanes>& lanes;
    std::vector<Block>& blocks;
};

/// One group, while its substeps are done.
struct Solver {
    StepContext& step;
    const SolverKernels& kernels;
    const SolveGroup& group;
    Contacts<PlainBlock> contacts;
    Contacts<PlainFixedBlock> fixedContacts;
    PlainBodies bodies;
    ContactPass pass;
    ContactPass fixedPass;  // stiffer: the ground does not give way
    float h;                // s
    int iterations;         // of each substep
};

PlainBodies bodiesOf(Workspace& work) {
    return {work.plainStates.data(), work.drive.data(), work.keep.empty() ? nullptr : work.keep.data(),
            work.flight.data(), work.undisturbed.data()};
}

/// Runs `act(contacts, pass, begin, end)` over the blocks of all colours.
template <class Act>
void forContacts(Solver& solver, Act&& act) {
    forColours(solver.group.contactColours, [&](int colour, int grain) {
        const ColourBlocks& blocks = solver.group.colours[colour];
        forRange(solver.step, blocks.contactBegin, blocks.contactEnd, grain,
                 [&](int begin, int end) { act(solver.contacts, solver.pass, begin, end); });
        forRange(solver.step, blocks.fixedBegin, blocks.fixedEnd, grain,
                 [&](int begin, int end) { act(solver.fixedContacts, solver.fixedPass, begin, end); });
    });
}

void warmStart(Solver& solver) {
    forContacts(solver, [&](auto& contacts, const ContactPass&, int begin, int end) {
        contacts.kernels.warmStart(solver.bodies, contacts.lanes.data(), contacts.blocks.data(), begin, end);
    });
}

void lock(Solver& solver) { lockAxes(solver.step, solver.group, solver.step.work.plainStates); }

void push(Solver& solver) {
    for (int i = 0; i < solver.iterations; ++i) {
        forContacts(solver, [&](auto& contacts, const ContactPass& pass, int begin, int end) {
            contacts.kernels.push(solver.bodies, pass, contacts.lanes.data(), contacts.blocks.data(), begin,
                                  end);
        });
        lock(solver);
    }
}

void relax(Solver& solver) {
    for (int i = 0; i < solver.iterations; ++i) {
        forContacts(solver, [&](auto& contacts, const ContactPass& pass, int begin, int end) {
            contacts.kernels.relax(solver.bodies, pass, contacts.lanes.data(), contacts.blocks.data(), begin,
                                   end);
        });
        lock(solver);
    }
}

void solveGroup(Solver& solver) {
    for (int i = 0; i < solver.group.substeps; ++i) {
        forBodies(solver.step, solver.group, [&](int begin, int end) {
            solver.kernels.acceleratePlain(solver.bodies, solver.h, i == 0, begin, end);
        });
        if (i == 0) warmStart(solver);
        lock(solver);
        solver.fixedPass.elapsed = solver.h * static_cast<float>(i);
        push(solver);
        forBodies(solver.step, solver.group,
                  [&](int begin, int end) { solver.kernels.movePlain(solver.bodies, begin, end); });
        relax(solver);
    }
}

void gatherStates(Workspace& work) {
    work.plainStates.resize(work.velocity.size());
    for (std::size_t i = 0; i < work.velocity.size(); ++i)
        work.plainStates[i] = {work.velocity[i].x, work.velocity[i].y, 0.0f, 0.0f};
}

/// A kinematic body may turn, though nobody is turned.
void turnBodies(Solver& solver) {
    Workspace& work = solver.step.work;
    const SolverBodies bodies{
        work.velocity.data(), work.shift.data(), nullptr, nullptr, work.flight.data(), nullptr};
    for (int i = 0; i < solver.group.substeps; ++i) {
        forBodies(solver.step, solver.group,
                  [&](int begin, int end) { solver.kernels.move(bodies, solver.h, begin, end); });
    }
}

void giveBack(Workspace& work) {
    for (std::size_t i = 0; i < work.velocity.size(); ++i) {
        const Float4& state = work.plainStates[i];
        work.velocity[i].x = state.x, work.velocity[i].y = state.y;
        work.shift[i].x = state.z, work.shift[i].y = state.w;
    }
}

}  // namespace

void solvePlain(StepContext& step) {
    Workspace& work = step.work;
    const Settings& settings = step.world.settings;
    const SolverKernels& kernels = solverKernels();
    const std::size_t rubs = step.runs(Effect::Friction) ? 1 : 0;
    prepareLocks(step);
    gatherStates(work);
    for (const SolveGroup& group : work.groups) {
        const float h = step.dt / static_cast<float>(group.substeps);
        Solver solver{step,
                      kernels,
                      group,
                      {kernels.plain[rubs], work.contactLanes, work.plainBlocks},
                      {kernels.plainFixed[rubs], work.fixedLanes, work.plainFixedBlocks},
                      bodiesOf(work),
                      contactPass(settings, h, 1.0f),
                      contactPass(settings, h, 2.0f),
                      h,
                      std::clamp<int>(settings.iterations, 1, kMostIterations)};
        solveGroup(solver);
        if (step.runs(Effect::Kinematics)) turnBodies(solver);
    }
    giveBack(work);
    storeImpulses(step, kernels.plain[rubs], work.contactLanes, work.plainBlocks);
    storeImpulses(step, kernels.plainFixed[rubs], work.fixedLanes, work.plainFixedBlocks);
}

}  // namespace plumb::physics
