#include "physics/solver/rolling.hpp"

#include <algorithm>

#include "physics/solver/passes.hpp"

namespace plumb::physics {

namespace {

float inverseInertiaOf(const RotatingSide& side, int i) { return side.inverseInertia[i]; }
float inverseInertiaOf(const FixedSide<2>&, int) { return 0.0f; }

/// rad/s. The blocks do not know that of a static or kinematic body.
float spinOf(Workspace& work, const RotatingSide& side, const RollingBlock&, int i) {
    return work.velocity[static_cast<std::size_t>(side.slot[i])].z;
}
float spinOf(Workspace&, const FixedSide<2>&, const RollingBlock& rolling, int i) { return rolling.spin[i]; }

void turn(Workspace& work, const RotatingSide& side, int i, float impulse) {
    work.velocity[static_cast<std::size_t>(side.slot[i])].z += side.inverseInertia[i] * impulse;
}
void turn(Workspace&, const FixedSide<2>&, int, float) {}

template <class Block>
void turnApart(Workspace& work, const Block& block, int i, float impulse) {
    turn(work, block.a, i, -impulse);
    turn(work, block.b, i, impulse);
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
            const float inverse = inverseInertiaOf(blocks[n].a, i) + inverseInertiaOf(blocks[n].b, i);
            rolling.mass[i] = inverse > 0.0f ? 1.0f / inverse : 0.0f;
            rolling.spin[i] = world.bodies.motion[contact.bodyA].angularVelocity;
            rolling.impulse[i] = contact.rollingResistance > 0.0f ? contact.rollingImpulse : 0.0f;
        }
    });
}

template <class Block>
void warmStartBlock(Workspace& work, const Block& block, const RollingBlock& rolling) {
    for (int i = 0; i < kLanes; ++i) {
        if (rolling.impulse[i] != 0.0f) turnApart(work, block, i, rolling.impulse[i]);
    }
}

template <class Block>
void relaxBlock(Workspace& work, const Block& block, RollingBlock& rolling) {
    for (int i = 0; i < kLanes; ++i) {
        if (rolling.resistance[i] == 0.0f) continue;
        const float pressed = block.points[0].impulse[i] + block.points[1].impulse[i];
        const float maximum = rolling.resistance[i] * pressed;
        const float before = rolling.impulse[i];
        const float speed = spinOf(work, block.b, rolling, i) - spinOf(work, block.a, rolling, i);
        const float wanted = before - rolling.mass[i] * speed;
        rolling.impulse[i] = std::clamp(wanted, -maximum, maximum);
        turnApart(work, block, i, rolling.impulse[i] - before);
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
