#include <algorithm>

#include "physics/solver/contact_extras.hpp"
#include "physics/solver/passes.hpp"

namespace plumb::physics {

namespace {

float impulseOf(const ImpulseSum& sum) {
    return std::fabs(*sum.points[0]) + (sum.points[1] != nullptr ? std::fabs(*sum.points[1]) : 0.0f);
}

template <class Block>
void startBlocks(StepContext& step, const std::vector<Block>& blocks, const std::vector<BlockLanes>& lanes,
                 BlockRange range) {
    Workspace& work = step.work;
    for (auto n = static_cast<std::size_t>(range.begin); n < static_cast<std::size_t>(range.end); ++n) {
        for (std::size_t i = 0; i < static_cast<std::size_t>(lanes[n].count); ++i) {
            const std::int32_t contact = lanes[n].contact[i];
            const std::uint16_t key = work.contactKeys[static_cast<std::size_t>(contact)];
            if (!step.world.settings.stayEvents && (key & kKeyBegan) == 0) continue;
            const float* second =
                Block::kPoints == 2 ? &blocks[n].points[Block::kPoints - 1].impulse[i] : nullptr;
            work.impulseSums.push_back({{&blocks[n].points[0].impulse[i], second}, 0.0f, contact});
        }
    }
}

}  // namespace

void clearImpulseSums(StepContext& step) {
    const std::vector<std::uint16_t>& keys = step.work.contactKeys;
    std::uint32_t any = step.world.settings.stayEvents ? kKeyBegan : 0;
    for (const std::uint16_t key : keys) any |= key;
    const bool sums = step.runs(Effect::ContactEvents) && (any & kKeyBegan) != 0;
    step.work.stepImpulses.assign(sums ? keys.size() : 0, 0.0f);
}

void startImpulseSums(StepContext& step, const SolveGroup& group) {
    Workspace& work = step.work;
    work.impulseSums.clear();
    if (work.stepImpulses.empty()) return;
    forStores(work, group.contacts(), [&](const auto& store, BlockRange range) {
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
        // An impact chain has taken back the impulses of the substeps: simultaneous_impacts.cpp.
        all = std::signbit(*sum.points[0]) ? -*sum.points[0] : all + (impulseOf(sum) - sum.last);
    }
}

void forgetImpulses(StepContext& step, const std::function<bool(std::uint32_t a, std::uint32_t b)>& isBad) {
    World& world = step.world;
    Workspace& work = step.work;
    for (const std::uint32_t j : world.joints.awake) {
        Joint& joint = world.joints.hot[j];
        // Gears and pulleys feel bodies of other joints too: what these did is no number then.
        if (std::isfinite(joint.rows[0] + joint.rows[1]) && !isBad(joint.bodyA, joint.bodyB)) continue;
        joint.force = {};
        joint.torque = 0.0f;
        std::fill(std::begin(joint.rows), std::end(joint.rows), 0.0f);
    }
    for (std::size_t i = 0; i < work.contactKeys.size(); ++i) {
        if (!pushes(work.contactKeys[i])) continue;
        Contact& contact = world.contacts[i];
        if (!isBad(contact.bodyA, contact.bodyB)) continue;
        contact.impulse0 = contact.impulse1 = contact.frictionImpulse = contact.rollingImpulse = 0.0f;
        if (i < work.stepImpulses.size()) work.stepImpulses[i] = 0.0f;
    }
}

}  // namespace plumb::physics
