#include "physics/solver/rolling.hpp"

#include <algorithm>

#include "physics/solver/passes.hpp"

namespace plumb::physics {

namespace {

float massOf(const ContactBlock& block, int i) {
    const float inverse = block.inverseInertiaA[i] + block.inverseInertiaB[i];
    return inverse > 0.0f ? 1.0f / inverse : 0.0f;
}
float massOf(const FixedContactBlock& block, int i) {
    return block.inverseInertia[i] > 0.0f ? 1.0f / block.inverseInertia[i] : 0.0f;
}

Float4& velocityAt(Workspace& work, std::int32_t slot) {
    return work.velocity[static_cast<std::size_t>(slot)];
}

/// rad/s of B relative to A.
float rollingSpeed(Workspace& work, const ContactBlock& block, const RollingBlock&, int i) {
    return velocityAt(work, block.b[i]).z - velocityAt(work, block.a[i]).z;
}
float rollingSpeed(Workspace& work, const FixedContactBlock& block, const RollingBlock& rolling, int i) {
    return velocityAt(work, block.b[i]).z - rolling.spin[i];
}

void turn(Workspace& work, const ContactBlock& block, int i, float impulse) {
    velocityAt(work, block.a[i]).z -= block.inverseInertiaA[i] * impulse;
    velocityAt(work, block.b[i]).z += block.inverseInertiaB[i] * impulse;
}
void turn(Workspace& work, const FixedContactBlock& block, int i, float impulse) {
    velocityAt(work, block.b[i]).z += block.inverseInertia[i] * impulse;
}

template <class Block>
void prepareBlocks(const StepContext& step, const std::vector<Block>& blocks,
                   const std::vector<BlockLanes>& lanes, std::vector<RollingBlock>& rollings) {
    const World& world = step.world;
    rollings.resize(blocks.size());
    forBlocks(step, 0, static_cast<int>(blocks.size()), kBlockGrain, [&](std::size_t n) {
        RollingBlock& rolling = rollings[n] = {};
        for (int i = 0; i < lanes[n].count; ++i) {
            const Contact& contact = world.contacts[static_cast<std::size_t>(lanes[n].contact[i])];
            rolling.resistance[i] = contact.rollingResistance;
            rolling.mass[i] = massOf(blocks[n], i);
            rolling.spin[i] = world.bodies.motion[contact.bodyA].angularVelocity;
            rolling.impulse[i] = contact.rollingResistance > 0.0f ? contact.rollingImpulse : 0.0f;
        }
    });
}

template <class Block>
void warmStartBlock(Workspace& work, const Block& block, const RollingBlock& rolling) {
    for (int i = 0; i < kLanes; ++i) {
        if (rolling.impulse[i] != 0.0f) turn(work, block, i, rolling.impulse[i]);
    }
}

template <class Block>
void relaxBlock(Workspace& work, const Block& block, RollingBlock& rolling) {
    for (int i = 0; i < kLanes; ++i) {
        if (rolling.resistance[i] <= 0.0f) continue;
        const float pressed = block.points[0].impulse[i] + block.points[1].impulse[i];
        const float maximum = rolling.resistance[i] * pressed;
        const float before = rolling.impulse[i];
        const float wanted = before - rolling.mass[i] * rollingSpeed(work, block, rolling, i);
        rolling.impulse[i] = std::clamp(wanted, -maximum, maximum);
        turn(work, block, i, rolling.impulse[i] - before);
    }
}

/// Calls act(block, rolling) with the blocks of a group, color by color.
template <class Act>
void forGroup(const StepContext& step, const SolveGroup& group, Act&& act) {
    Workspace& work = step.work;
    for (const ColourBlocks& colour : group.colours) {
        const int grain = &colour == &group.colours[kOverflow] ? kSequential : kBlockGrain;
        forBlocks(step, colour.contactBegin, colour.contactEnd, grain,
                  [&](std::size_t n) { act(work.contactBlocks[n], work.rollings[n]); });
        forBlocks(step, colour.fixedBegin, colour.fixedEnd, grain,
                  [&](std::size_t n) { act(work.fixedBlocks[n], work.fixedRollings[n]); });
    }
}

void storeBlocks(StepContext& step, const std::vector<BlockLanes>& lanes,
                 const std::vector<RollingBlock>& rollings) {
    forBlocks(step, 0, static_cast<int>(rollings.size()), kBlockGrain, [&](std::size_t n) {
        for (int i = 0; i < lanes[n].count; ++i) {
            step.world.contacts[static_cast<std::size_t>(lanes[n].contact[i])].rollingImpulse =
                rollings[n].impulse[i];
        }
    });
}

bool rolls(const StepContext& step) { return step.runs(Effect::Rolling); }

}  // namespace

void prepareRolling(StepContext& step) {
    if (!step.starts(Effect::Rolling)) return;
    prepareBlocks(step, step.work.contactBlocks, step.work.contactLanes, step.work.rollings);
    prepareBlocks(step, step.work.fixedBlocks, step.work.fixedLanes, step.work.fixedRollings);
}

void warmStartRolling(StepContext& step, const SolveGroup& group) {
    if (!rolls(step)) return;
    forGroup(step, group, [&](const auto& block, const RollingBlock& rolling) {
        warmStartBlock(step.work, block, rolling);
    });
}

void relaxRolling(StepContext& step, const SolveGroup& group) {
    if (!rolls(step)) return;
    forGroup(step, group,
             [&](const auto& block, RollingBlock& rolling) { relaxBlock(step.work, block, rolling); });
}

void storeRolling(StepContext& step) {
    if (!rolls(step)) return;
    storeBlocks(step, step.work.contactLanes, step.work.rollings);
    storeBlocks(step, step.work.fixedLanes, step.work.fixedRollings);
}

}  // namespace plumb::physics
