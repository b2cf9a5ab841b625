#include "physics/solver/contact_extras.hpp"

#include <algorithm>

#include "physics/solver/contact_sides.hpp"
#include "physics/solver/passes.hpp"

namespace plumb::physics {

namespace {

// Restitution.

template <class Block>
void prepareBlock(const StepContext& step, const Block& block, const BlockLanes& lanes, BounceBlock& bounce) {
    for (int i = 0; i < lanes.count; ++i) {
        const Contact& contact = step.world.contacts[static_cast<std::size_t>(lanes.index[i])];
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
    for (int i = 0; i < kLanes; ++i) {
        for (int p = 0; p < 2; ++p)
            bounce.largest[p][i] = std::max(bounce.largest[p][i], block.points[p].impulse[i]);
        if (bounce.sum[i] >= 0.0f) bounce.sum[i] += block.points[0].impulse[i];
    }
}

/// Applies restitution at one of the two points of a contact.
template <class Block>
void bouncePoint(StepContext& step, Block& block, const BounceBlock& bounce, int p, int i) {
    if (bounce.approach[p][i] > -step.world.settings.bounceSpeed || bounce.largest[p][i] == 0.0f) return;
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
        for (int left = both ? kTwoPointTurns : 1; left > 0; --left) {
            for (int p = 0; p < 2; ++p) bouncePoint(step, block, bounce, p, i);
        }
    }
}

// Rolling resistance.

float inverseInertiaOf(const RotatingSide& side, int i) { return side.inverseInertia[i]; }
float inverseInertiaOf(const FixedSide<2>&, int) { return 0.0f; }

/// Returns the angular velocity (rad/s) of a side. For static and kinematic bodies RollingBlock stores it.
float spinOf(Workspace& work, const RotatingSide& side, const RollingBlock&, int i) {
    return work.velocity[static_cast<std::size_t>(side.slot[i])].z;
}
float spinOf(Workspace&, const FixedSide<2>&, const RollingBlock& rolling, int i) { return rolling.spin[i]; }

void applyTorque(Workspace& work, const RotatingSide& side, int i, float impulse) {
    work.velocity[static_cast<std::size_t>(side.slot[i])].z += side.inverseInertia[i] * impulse;
}
void applyTorque(Workspace&, const FixedSide<2>&, int, float) {}

template <class Block>
void turnApart(Workspace& work, const Block& block, int i, float impulse) {
    applyTorque(work, block.a, i, -impulse);
    applyTorque(work, block.b, i, impulse);
}

template <class Block>
void prepareBlock(const World& world, const Block& block, const BlockLanes& lanes, RollingBlock& rolling) {
    rolling = {};
    for (int i = 0; i < lanes.count; ++i) {
        const Contact& contact = world.contacts[static_cast<std::size_t>(lanes.index[i])];
        rolling.resistance[i] = contact.rollingResistance;
        const float inverse = inverseInertiaOf(block.a, i) + inverseInertiaOf(block.b, i);
        rolling.mass[i] = inverse > 0.0f ? 1.0f / inverse : 0.0f;
        rolling.spin[i] = world.bodies.motion[contact.bodyA].angularVelocity;
        rolling.impulse[i] = contact.rollingResistance > 0.0f ? contact.rollingImpulse : 0.0f;
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

// Impulse sums for events.

float impulseOf(const ImpulseSum& sum) {
    return std::fabs(*sum.points[0]) + (sum.points[1] != nullptr ? std::fabs(*sum.points[1]) : 0.0f);
}

template <class Block>
void startBlocks(StepContext& step, const std::vector<Block>& blocks, const std::vector<BlockLanes>& lanes,
                 BlockRange range) {
    for (auto n = static_cast<std::size_t>(range.begin); n < static_cast<std::size_t>(range.end); ++n) {
        for (std::size_t i = 0; i < static_cast<std::size_t>(lanes[n].count); ++i) {
            const std::int32_t contact = lanes[n].index[i];
            const std::uint16_t key = step.work.contactKeys[static_cast<std::size_t>(contact)];
            if (!step.world.settings.stayEvents && (key & kKeyBegan) == 0) continue;
            const float* second =
                Block::kPoints == 2 ? &blocks[n].points[Block::kPoints - 1].impulse[i] : nullptr;
            step.work.impulseSums.push_back({{&blocks[n].points[0].impulse[i], second}, 0.0f, contact});
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
        for (int i = 0; i < kLanes; ++i) {
            const float impulse = store.rollings[n].impulse[i];
            if (impulse != 0.0f) turnApart(step.work, store.blocks[n], i, impulse);
        }
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
            step.world.contacts[static_cast<std::size_t>(store.lanes[n].index[i])].rollingImpulse =
                store.rollings[n].impulse[i];
        }
    });
}

void clearImpulseSums(StepContext& step) {
    const std::vector<std::uint16_t>& keys = step.work.contactKeys;
    std::uint32_t any = step.world.settings.stayEvents ? kKeyBegan : 0;
    for (const std::uint16_t key : keys) any |= key;
    const bool sums = step.runs(Effect::ContactEvents) && (any & kKeyBegan) != 0;
    step.work.stepImpulses.assign(sums ? keys.size() : 0, 0.0f);
}

void startImpulseSums(StepContext& step, const SolveGroup& group) {
    step.work.impulseSums.clear();
    if (step.work.stepImpulses.empty()) return;
    forStores(step.work, group.contacts(), [&](const auto& store, BlockRange range) {
        group.withoutRotation ? startBlocks(step, store.blocksWithoutRotation, store.lanes, range)
                              : startBlocks(step, store.blocks, store.lanes, range);
    });
}

void addImpulses(Workspace& work) {
    for (ImpulseSum& sum : work.impulseSums) {
        sum.last = impulseOf(sum);
        work.stepImpulses[static_cast<std::size_t>(sum.contact)] += sum.last;
    }
}

void finishImpulseSums(Workspace& work) {
    for (const ImpulseSum& sum : work.impulseSums) {
        float& all = work.stepImpulses[static_cast<std::size_t>(sum.contact)];
        // Negative: a propagated impact, which replaces the sum (simultaneous_impacts.cpp).
        all = std::signbit(*sum.points[0]) ? -*sum.points[0] : all + (impulseOf(sum) - sum.last);
    }
}

void forgetImpulses(StepContext& step, const std::function<bool(std::uint32_t a, std::uint32_t b)>& isBad) {
    Workspace& work = step.work;
    for (const std::uint32_t j : step.world.joints.awake) {
        Joint& joint = step.world.joints.hot[j];
        // Gears and pulleys may spread non-finite impulses to the joints of other bodies.
        if (std::isfinite(joint.rows[0] + joint.rows[1]) && !isBad(joint.bodyA, joint.bodyB)) continue;
        joint.force = {};
        joint.torque = 0.0f;
        std::fill(std::begin(joint.rows), std::end(joint.rows), 0.0f);
    }
    for (std::size_t i = 0; i < work.contactKeys.size(); ++i) {
        if (!pushes(work.contactKeys[i])) continue;
        Contact& contact = step.world.contacts[i];
        if (!isBad(contact.bodyA, contact.bodyB)) continue;
        contact.impulse0 = contact.impulse1 = contact.frictionImpulse = contact.rollingImpulse = 0.0f;
        if (i < work.stepImpulses.size()) work.stepImpulses[i] = 0.0f;
    }
}

}  // namespace plumb::physics
