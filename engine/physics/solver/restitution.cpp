#include <algorithm>

#include "physics/solver/contact_extras.hpp"
#include "physics/solver/contact_sides.hpp"
#include "physics/solver/passes.hpp"

namespace plumb::physics {

namespace {

template <class Block>
void prepareBlock(const StepContext& step, const Block& block, const BlockLanes& lanes, BounceBlock& bounce) {
    for (int i = 0; i < lanes.count; ++i) {
        const Contact& contact = step.world.contacts[static_cast<std::size_t>(lanes.contact[i])];
        bounce.bounciness[i] = contact.bounciness;
        bounce.before[i] = contact.impulse0;
        bounce.sum[i] = (contact.flags & kRound) != 0 && contact.bounciness > 0.0f ? 0.0f : kNoChain;
        for (int p = 0; p < 2; ++p) {
            bounce.approach[p][i] = approachOf(step.work, block, p, i);
            bounce.largest[p][i] = 0.0f;
        }
    }
}

template <class Block>
void noteImpulses(const Block& block, BounceBlock& bounce) {
    for (int p = 0; p < 2; ++p) {
        for (int i = 0; i < kLanes; ++i)
            bounce.largest[p][i] = std::max(bounce.largest[p][i], block.points[p].impulse[i]);
    }
    for (int i = 0; i < kLanes; ++i) {
        if (bounce.sum[i] >= 0.0f) bounce.sum[i] += block.points[0].impulse[i];
    }
}

/// Restitution at one of the two points of a contact.
template <class Block>
void bouncePoint(StepContext& step, Block& block, const BounceBlock& bounce, int p, int i) {
    const float slowest = step.world.settings.bounceSpeed;
    if (bounce.approach[p][i] > -slowest || bounce.largest[p][i] == 0.0f) return;
    auto& point = block.points[p];
    const float speed = approachOf(step.work, block, p, i), before = point.impulse[i];
    const float leaving = speedOfBounce(bounce.approach[p][i], bounce.bounciness[i], point.separation[i],
                                        approachIn(step.work, block, p, i, step.dt));
    point.impulse[i] = std::max(before - point.mass[i] * (speed - leaving), 0.0f);
    pushApart(step.work, block, p, i, point.impulse[i] - before);
}

template <class Block>
void bounceBlock(StepContext& step, Block& block, const BlockLanes& lanes, const BounceBlock& bounce) {
    for (int i = 0; i < lanes.count; ++i) {
        if (bounce.bounciness[i] == 0.0f) continue;
        const bool both = bounce.largest[0][i] > 0.0f && bounce.largest[1][i] > 0.0f;
        for (int turn = both ? kTwoPointTurns : 1; turn > 0; --turn) {
            for (int p = 0; p < 2; ++p) bouncePoint(step, block, bounce, p, i);
        }
    }
}

}  // namespace

void prepareRestitution(StepContext& step) {
    if (!step.starts(Effect::Restitution)) return;
    forStores(step.work, {}, [&](auto& store, BlockRange) { store.bounces.resize(store.blocks.size()); });
    forAllBlocks(step, [&](auto& store, std::size_t n) {
        prepareBlock(step, store.blocks[n], store.lanes[n], store.bounces[n]);
    });
}

void noteLargestImpulses(StepContext& step, const SolveGroup& group) {
    if (!step.runs(Effect::Restitution)) return;
    forStores(step.work, group.contacts(), [&](auto& store, BlockRange range) {
        forBlocks(step, range, kBlockGrain,
                  [&](std::size_t n) { noteImpulses(store.blocks[n], store.bounces[n]); });
    });
}

void applyRestitution(StepContext& step, const SolveGroup& group) {
    if (!step.runs(Effect::Restitution)) return;
    runImpactsOn(step, group);
    forGroup(step, group, [&](auto& store, std::size_t n) {
        bounceBlock(step, store.blocks[n], store.lanes[n], store.bounces[n]);
    });
}

}  // namespace plumb::physics
