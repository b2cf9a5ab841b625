#include "physics/solver/restitution.hpp"

#include <algorithm>
#include <cmath>

#include "physics/solver/contact_sides.hpp"
#include "physics/solver/passes.hpp"
#include "physics/solver/simultaneous_impacts.hpp"
#include "physics/tuning.hpp"

namespace plumb::physics {

namespace {

template <class Block>
void prepareBlocks(StepContext& step, const std::vector<Block>& blocks, const std::vector<BlockLanes>& lanes,
                   std::vector<BounceBlock>& bounces) {
    bounces.resize(blocks.size());
    forBlocks(step, 0, static_cast<int>(blocks.size()), kBlockGrain, [&](std::size_t n) {
        BounceBlock& bounce = bounces[n];
        for (int i = 0; i < lanes[n].count; ++i) {
            const Contact& contact = step.world.contacts[static_cast<std::size_t>(lanes[n].contact[i])];
            bounce.bounciness[i] = contact.bounciness;
            bounce.before[i] = contact.impulse0;
            bounce.sum[i] = (contact.flags & kRound) != 0 && contact.bounciness > 0.0f ? 0.0f : kNoChain;
            for (int p = 0; p < 2; ++p) {
                bounce.approach[p][i] = approachOf(step.work, blocks[n], p, i);
                bounce.largest[p][i] = 0.0f;
            }
        }
    });
}

template <class Block>
void noteBlocks(const StepContext& step, const std::vector<Block>& blocks, std::vector<BounceBlock>& bounces,
                int begin, int end) {
    forBlocks(step, begin, end, kBlockGrain, [&](std::size_t n) {
        BounceBlock& bounce = bounces[n];
        for (int p = 0; p < 2; ++p) {
            for (int i = 0; i < kLanes; ++i)
                bounce.largest[p][i] = std::max(bounce.largest[p][i], blocks[n].points[p].impulse[i]);
        }
        for (int i = 0; i < kLanes; ++i) {
            if (bounce.sum[i] >= 0.0f) bounce.sum[i] += blocks[n].points[0].impulse[i];
        }
    });
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
void bounceBlocks(StepContext& step, std::vector<Block>& blocks, const std::vector<BlockLanes>& lanes,
                  const std::vector<BounceBlock>& bounces, int begin, int end, int grain) {
    forBlocks(step, begin, end, grain, [&](std::size_t n) {
        const BounceBlock& bounce = bounces[n];
        for (int i = 0; i < lanes[n].count; ++i) {
            if (bounce.bounciness[i] == 0.0f) continue;
            const bool both = bounce.largest[0][i] > 0.0f && bounce.largest[1][i] > 0.0f;
            for (int turn = both ? kTwoPointTurns : 1; turn > 0; --turn) {
                for (int p = 0; p < 2; ++p) bouncePoint(step, blocks[n], bounce, p, i);
            }
        }
    });
}

bool bounces(const StepContext& step) { return step.runs(Effect::Restitution); }

}  // namespace

void prepareRestitution(StepContext& step) {
    if (!step.starts(Effect::Restitution)) return;
    Workspace& work = step.work;
    prepareBlocks(step, work.contactBlocks, work.contactLanes, work.bounces);
    prepareBlocks(step, work.fixedBlocks, work.fixedLanes, work.fixedBounces);
}

void noteLargestImpulses(StepContext& step, const SolveGroup& group) {
    if (!bounces(step)) return;
    const ColourBlocks &first = group.colours[0], &last = group.colours[kColours];
    noteBlocks(step, step.work.contactBlocks, step.work.bounces, first.contactBegin, last.contactEnd);
    noteBlocks(step, step.work.fixedBlocks, step.work.fixedBounces, first.fixedBegin, last.fixedEnd);
}

void applyRestitution(StepContext& step, const SolveGroup& group) {
    if (!bounces(step)) return;
    runImpactsOn(step, group);
    Workspace& work = step.work;
    for (const ColourBlocks& colour : group.colours) {
        const int grain = &colour == &group.colours[kOverflow] ? kSequential : kBlockGrain;
        bounceBlocks(step, work.contactBlocks, work.contactLanes, work.bounces, colour.contactBegin,
                     colour.contactEnd, grain);
        bounceBlocks(step, work.fixedBlocks, work.fixedLanes, work.fixedBounces, colour.fixedBegin,
                     colour.fixedEnd, grain);
    }
}

}  // namespace plumb::physics
