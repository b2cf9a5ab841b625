#include "physics/solver/restitution.hpp"

#include <algorithm>
#include <cmath>

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

/// m: how far a body's point moved along the normal in this step.
float movedAlong(const Float4& shift, float nx, float ny, float lever, float turn) {
    return shift.x * nx + shift.y * ny + (shift.z * lever + shift.w * turn);
}

/// How two bodies came together during the step, along the normal.
struct Approach {
    float way;           // m: how much further they are apart than before the step
    float acceleration;  // m/s2 of B from A
};

Approach approachIn(const Workspace& work, const ContactBlock& block, int p, int i, float /*dt*/) {
    const auto a = static_cast<std::size_t>(block.a[i]), b = static_cast<std::size_t>(block.b[i]);
    const float nx = block.normalX[i], ny = block.normalY[i];
    return {movedAlong(work.shift[b], nx, ny, block.points[p].leverB[i], block.turnB[i]) -
                movedAlong(work.shift[a], nx, ny, block.points[p].leverA[i], block.turnA[i]),
            (work.drive[b].x - work.drive[a].x) * nx + (work.drive[b].y - work.drive[a].y) * ny};
}
Approach approachIn(const Workspace& work, const FixedContactBlock& block, int p, int i, float dt) {
    const auto b = static_cast<std::size_t>(block.b[i]);
    const float nx = block.normalX[i], ny = block.normalY[i];
    return {movedAlong(work.shift[b], nx, ny, block.points[p].lever[i], block.turn[i]) -
                block.points[p].approach[i] * dt,
            work.drive[b].x * nx + work.drive[b].y * ny};
}

/// m/s: how fast they met, by v2 = v0 2 + 2 a s. Between the start of the step and the impact gravity went on:
/// without it a ball would lose, or gain, some height in each bounce.
float speedOfImpact(float before, const Approach& approach) {
    return -std::sqrt(std::max(before * before + 2.0f * approach.acceleration * approach.way, 0.0f));
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
                const float met =
                    speedOfImpact(bounce.approach[p][i], approachIn(step.work, blocks[n], p, i, step.dt));
                point.impulse[i] =
                    std::max(before - point.mass[i] * (speed + bounce.bounciness[i] * met), 0.0f);
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
