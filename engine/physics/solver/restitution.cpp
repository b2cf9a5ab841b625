#include "physics/solver/restitution.hpp"

#include <algorithm>

namespace plumb::physics {

namespace {

/// A body's part in one point of a contact.
struct Side {
    Float4* velocity;
    float inverseInertia;
    float lever;
};

float speedAlong(const Side& side, float nx, float ny) {
    return side.velocity->x * nx + side.velocity->y * ny + side.velocity->z * side.lever;
}

void pushAlong(const Side& side, float impulse, float nx, float ny) {
    side.velocity->x += side.velocity->w * (impulse * nx);
    side.velocity->y += side.velocity->w * (impulse * ny);
    side.velocity->z += side.inverseInertia * (impulse * side.lever);
}

Side sideA(Workspace& work, const ContactBlock& block, int p, int i) {
    return {&work.velocity[static_cast<std::size_t>(block.a[i])], block.inverseInertiaA[i],
            block.points[p].leverA[i]};
}
Side sideB(Workspace& work, const ContactBlock& block, int p, int i) {
    return {&work.velocity[static_cast<std::size_t>(block.b[i])], block.inverseInertiaB[i],
            block.points[p].leverB[i]};
}
Side sideB(Workspace& work, const FixedContactBlock& block, int p, int i) {
    return {&work.velocity[static_cast<std::size_t>(block.b[i])], block.inverseInertia[i],
            block.points[p].lever[i]};
}

float approachOf(Workspace& work, const ContactBlock& block, int p, int i) {
    return speedAlong(sideB(work, block, p, i), block.normalX[i], block.normalY[i]) -
           speedAlong(sideA(work, block, p, i), block.normalX[i], block.normalY[i]);
}
float approachOf(Workspace& work, const FixedContactBlock& block, int p, int i) {
    return speedAlong(sideB(work, block, p, i), block.normalX[i], block.normalY[i]) -
           block.points[p].approach[i];
}

void pushApart(Workspace& work, const ContactBlock& block, int p, int i, float impulse) {
    pushAlong(sideA(work, block, p, i), -impulse, block.normalX[i], block.normalY[i]);
    pushAlong(sideB(work, block, p, i), impulse, block.normalX[i], block.normalY[i]);
}
void pushApart(Workspace& work, const FixedContactBlock& block, int p, int i, float impulse) {
    pushAlong(sideB(work, block, p, i), impulse, block.normalX[i], block.normalY[i]);
}

template <class Block>
void prepareBlocks(StepContext& step, const std::vector<Block>& blocks, const std::vector<BlockLanes>& lanes,
                   std::vector<BounceBlock>& bounces) {
    bounces.resize(blocks.size());
    for (std::size_t n = 0; n < blocks.size(); ++n) {
        BounceBlock& bounce = bounces[n];
        for (int i = 0; i < lanes[n].count; ++i) {
            bounce.bounciness[i] =
                step.world.contacts[static_cast<std::size_t>(lanes[n].contact[i])].bounciness;
            for (int p = 0; p < 2; ++p) {
                bounce.approach[p][i] = approachOf(step.work, blocks[n], p, i);
                bounce.largest[p][i] = 0.0f;
            }
        }
    }
}

template <class Block>
void noteBlocks(const std::vector<Block>& blocks, std::vector<BounceBlock>& bounces, int begin, int end) {
    for (auto n = static_cast<std::size_t>(begin); n < static_cast<std::size_t>(end); ++n) {
        for (int p = 0; p < 2; ++p) {
            for (int i = 0; i < kLanes; ++i) {
                bounces[n].largest[p][i] = std::max(bounces[n].largest[p][i], blocks[n].points[p].impulse[i]);
            }
        }
    }
}

template <class Block>
void bounceBlocks(StepContext& step, std::vector<Block>& blocks, const std::vector<BlockLanes>& lanes,
                  const std::vector<BounceBlock>& bounces, int begin, int end) {
    const float slowest = step.world.settings.bounceSpeed;
    for (auto n = static_cast<std::size_t>(begin); n < static_cast<std::size_t>(end); ++n) {
        const BounceBlock& bounce = bounces[n];
        for (int i = 0; i < lanes[n].count; ++i) {
            if (bounce.bounciness[i] == 0.0f) continue;
            for (int p = 0; p < 2; ++p) {
                if (bounce.approach[p][i] > -slowest || bounce.largest[p][i] == 0.0f) continue;
                auto& point = blocks[n].points[p];
                const float speed = approachOf(step.work, blocks[n], p, i);
                const float before = point.impulse[i];
                point.impulse[i] = std::max(
                    before - point.mass[i] * (speed + bounce.bounciness[i] * bounce.approach[p][i]), 0.0f);
                pushApart(step.work, blocks[n], p, i, point.impulse[i] - before);
            }
        }
    }
}

bool bounces(const StepContext& step) { return step.world.manifest.runs(Effect::Restitution); }

}  // namespace

void prepareRestitution(StepContext& step) {
    if (!bounces(step)) return;
    Workspace& work = step.work;
    prepareBlocks(step, work.contactBlocks, work.contactLanes, work.bounces);
    prepareBlocks(step, work.fixedBlocks, work.fixedLanes, work.fixedBounces);
}

void noteLargestImpulses(StepContext& step, const SolveGroup& group) {
    if (!bounces(step)) return;
    for (const ColourBlocks& colour : group.colours) {
        noteBlocks(step.work.contactBlocks, step.work.bounces, colour.contactBegin, colour.contactEnd);
        noteBlocks(step.work.fixedBlocks, step.work.fixedBounces, colour.fixedBegin, colour.fixedEnd);
    }
}

void applyRestitution(StepContext& step, const SolveGroup& group) {
    if (!bounces(step)) return;
    Workspace& work = step.work;
    for (const ColourBlocks& colour : group.colours) {
        bounceBlocks(step, work.contactBlocks, work.contactLanes, work.bounces, colour.contactBegin,
                     colour.contactEnd);
        bounceBlocks(step, work.fixedBlocks, work.fixedLanes, work.fixedBounces, colour.fixedBegin,
                     colour.fixedEnd);
    }
}

}  // namespace plumb::physics
