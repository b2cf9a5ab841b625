#include "physics/solver/rolling.hpp"

#include <algorithm>

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
void prepareBlocks(const World& world, const std::vector<Block>& blocks, const std::vector<BlockLanes>& lanes,
                   std::vector<RollingBlock>& rollings) {
    rollings.resize(blocks.size());
    for (std::size_t n = 0; n < blocks.size(); ++n) {
        RollingBlock& rolling = rollings[n] = {};
        for (int i = 0; i < lanes[n].count; ++i) {
            const Contact& contact = world.contacts[static_cast<std::size_t>(lanes[n].contact[i])];
            rolling.resistance[i] = contact.rollingResistance;
            rolling.mass[i] = massOf(blocks[n], i);
            rolling.spin[i] = world.bodies.motion[contact.bodyA].angularVelocity;
            rolling.impulse[i] = contact.rollingResistance > 0.0f ? contact.rollingImpulse : 0.0f;
        }
    }
}

template <class Block>
void warmStartBlocks(Workspace& work, const std::vector<Block>& blocks,
                     const std::vector<RollingBlock>& rollings, int begin, int end) {
    for (auto n = static_cast<std::size_t>(begin); n < static_cast<std::size_t>(end); ++n) {
        for (int i = 0; i < kLanes; ++i) {
            if (rollings[n].impulse[i] != 0.0f) turn(work, blocks[n], i, rollings[n].impulse[i]);
        }
    }
}

template <class Block>
void relaxBlocks(Workspace& work, const std::vector<Block>& blocks, std::vector<RollingBlock>& rollings,
                 int begin, int end) {
    for (auto n = static_cast<std::size_t>(begin); n < static_cast<std::size_t>(end); ++n) {
        RollingBlock& rolling = rollings[n];
        for (int i = 0; i < kLanes; ++i) {
            if (rolling.resistance[i] <= 0.0f) continue;
            const float pressed = blocks[n].points[0].impulse[i] + blocks[n].points[1].impulse[i];
            const float maximum = rolling.resistance[i] * pressed;
            const float before = rolling.impulse[i];
            const float wanted = before - rolling.mass[i] * rollingSpeed(work, blocks[n], rolling, i);
            rolling.impulse[i] = std::clamp(wanted, -maximum, maximum);
            turn(work, blocks[n], i, rolling.impulse[i] - before);
        }
    }
}

void storeBlocks(World& world, const std::vector<BlockLanes>& lanes,
                 const std::vector<RollingBlock>& rollings) {
    for (std::size_t n = 0; n < rollings.size(); ++n) {
        for (int i = 0; i < lanes[n].count; ++i) {
            world.contacts[static_cast<std::size_t>(lanes[n].contact[i])].rollingImpulse =
                rollings[n].impulse[i];
        }
    }
}

bool rolls(const StepContext& step) { return step.runs(Effect::Rolling); }

}  // namespace

void prepareRolling(StepContext& step) {
    if (!step.starts(Effect::Rolling)) return;
    prepareBlocks(step.world, step.work.contactBlocks, step.work.contactLanes, step.work.rollings);
    prepareBlocks(step.world, step.work.fixedBlocks, step.work.fixedLanes, step.work.fixedRollings);
}

void warmStartRolling(StepContext& step, const SolveGroup& group) {
    if (!rolls(step)) return;
    Workspace& work = step.work;
    for (const ColourBlocks& colour : group.colours) {
        warmStartBlocks(work, work.contactBlocks, work.rollings, colour.contactBegin, colour.contactEnd);
        warmStartBlocks(work, work.fixedBlocks, work.fixedRollings, colour.fixedBegin, colour.fixedEnd);
    }
}

void relaxRolling(StepContext& step, const SolveGroup& group) {
    if (!rolls(step)) return;
    Workspace& work = step.work;
    for (const ColourBlocks& colour : group.colours) {
        relaxBlocks(work, work.contactBlocks, work.rollings, colour.contactBegin, colour.contactEnd);
        relaxBlocks(work, work.fixedBlocks, work.fixedRollings, colour.fixedBegin, colour.fixedEnd);
    }
}

void storeRolling(StepContext& step) {
    if (!rolls(step)) return;
    storeBlocks(step.world, step.work.contactLanes, step.work.rollings);
    storeBlocks(step.world, step.work.fixedLanes, step.work.fixedRollings);
}

}  // namespace plumb::physics
