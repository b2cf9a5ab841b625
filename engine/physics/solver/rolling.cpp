#include <algorithm>

#include "physics/solver/contact_extras.hpp"
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
void prepareBlock(const World& world, const Block& block, const BlockLanes& lanes, RollingBlock& rolling) {
    rolling = {};
    for (int i = 0; i < lanes.count; ++i) {
        const Contact& contact = world.contacts[static_cast<std::size_t>(lanes.contact[i])];
        rolling.resistance[i] = contact.rollingResistance;
        const float inverse = inverseInertiaOf(block.a, i) + inverseInertiaOf(block.b, i);
        rolling.mass[i] = inverse > 0.0f ? 1.0f / inverse : 0.0f;
        rolling.spin[i] = world.bodies.motion[contact.bodyA].angularVelocity;
        rolling.impulse[i] = contact.rollingResistance > 0.0f ? contact.rollingImpulse : 0.0f;
    }
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

}  // namespace

void prepareRolling(StepContext& step) {
    if (!step.starts(Effect::Rolling)) return;
    forStores(step.work, {}, [&](auto& store, BlockRange) { store.rollings.resize(store.blocks.size()); });
    forAllBlocks(step, [&](auto& store, std::size_t n) {
        prepareBlock(step.world, store.blocks[n], store.lanes[n], store.rollings[n]);
    });
}

void warmStartRolling(StepContext& step, const SolveGroup& group) {
    if (!step.runs(Effect::Rolling)) return;
    forGroup(step, group, [&](const auto& store, std::size_t n) {
        warmStartBlock(step.work, store.blocks[n], store.rollings[n]);
    });
}

void relaxRolling(StepContext& step, const SolveGroup& group) {
    if (!step.runs(Effect::Rolling)) return;
    forGroup(step, group,
             [&](auto& store, std::size_t n) { relaxBlock(step.work, store.blocks[n], store.rollings[n]); });
}

void storeRolling(StepContext& step) {
    if (!step.runs(Effect::Rolling)) return;
    forAllBlocks(step, [&](const auto& store, std::size_t n) {
        for (int i = 0; i < store.lanes[n].count; ++i) {
            step.world.contacts[static_cast<std::size_t>(store.lanes[n].contact[i])].rollingImpulse =
                store.rollings[n].impulse[i];
        }
    });
}

}  // namespace plumb::physics
