#pragma once

#include <bit>

#include "physics/stages.hpp"

namespace plumb::physics {

// Passes over the bodies and constraints of a group, distributed over threads.

inline constexpr int kBlockGrain = 8;        ///< blocks per piece of work
inline constexpr int kSequential = 1 << 30;  ///< value of a grain: one piece
inline constexpr int kBodyGrain = 256;       ///< bodies per piece of work

/// @param h  s: substep
inline ContactPass contactPass(const Settings& settings, float h) {
    return {.softness = softness(settings.contactStiffness / h, settings.contactDampingRatio, h),
            .substepRate = 1.0f / h,
            .pushSpeed = settings.pushSpeed,
            .deepPushRate = settings.deepPushRate};
}

/// Runs `act(begin, end)` over a range of blocks or slots, in pieces.
template <class Act>
void forRange(const StepContext& step, BlockRange range, int grain, Act&& act) {
    forPieces(step.pool, range.end - range.begin, grain,
              [=](int first, int last, int) { act(range.begin + first, range.begin + last); });
}

/// Runs `act(n)` for the blocks of a range.
template <class Act>
void forBlocks(const StepContext& step, BlockRange range, int grain, Act&& act) {
    forRange(step, range, grain, [=](int first, int last) {
        for (int n = first; n < last; ++n) act(static_cast<std::size_t>(n));
    });
}

template <class Act>
void forBodies(const StepContext& step, const SolveGroup& group, Act&& act) {
    forRange(step, {group.begin, group.end}, kBodyGrain, act);
}

/// Runs `act(colour, grain)` for each color of a bit set: the overflow first, in one sequential piece.
template <class Act>
void forColours(std::uint64_t colours, Act&& act) {
    if ((colours >> kOverflow & 1) != 0) act(int{kOverflow}, kSequential);
    for (std::uint64_t rest = colours & ((std::uint64_t{1} << kColours) - 1); rest != 0; rest &= rest - 1)
        act(std::countr_zero(rest), kBlockGrain);
}

/// Runs `act(store, range)` for both kinds of contacts.
template <class Act>
void forStores(Workspace& work, const ContactRanges& ranges, Act&& act) {
    act(work.two, ranges.two);
    act(work.fixed, ranges.fixed);
}

/// Returns the blocks of groups with rotation, or of groups without, which follow them.
inline ContactRanges blocksOf(const Workspace& work, bool withoutRotation) {
    ContactRanges ranges;
    for (const SolveGroup& group : work.groups) {
        if (!group.withoutRotation) ranges = {{0, group.contacts().two.end}, {0, group.contacts().fixed.end}};
    }
    if (!withoutRotation) return ranges;
    return {{ranges.two.end, static_cast<std::int32_t>(work.two.lanes.size())},
            {ranges.fixed.end, static_cast<std::int32_t>(work.fixed.lanes.size())}};
}

/// Runs `act(store, n)` for all blocks of groups with rotation, in any order.
template <class Act>
void forAllBlocks(StepContext& step, Act&& act) {
    forStores(step.work, blocksOf(step.work, false), [&](auto& store, BlockRange range) {
        forBlocks(step, range, kBlockGrain, [&](std::size_t n) { act(store, n); });
    });
}

/// Runs `act(store, n)` for the blocks of a group with rotation, color by color.
template <class Act>
void forGroup(StepContext& step, const SolveGroup& group, Act&& act) {
    for (const ColourBlocks& colour : group.colours) {
        const int grain = &colour == &group.colours[kOverflow] ? kSequential : kBlockGrain;
        forStores(step.work, colour.contacts, [&](auto& store, BlockRange range) {
            forBlocks(step, range, grain, [&](std::size_t n) { act(store, n); });
        });
    }
}

/// Contacts of one kind, with their kernels and the parameters of a pass.
template <class Block, class Bodies>
struct ContactSet {
    const ContactKernels<Block, Bodies>& kernels;
    const std::vector<BlockLanes>& lanes;
    std::vector<Block>& blocks;
    BlockRange used;  ///< blocks of these kernels
    ContactPass pass{};

    void prepare(const StepContext& step, const ContactSource& source) const {
        constexpr int kGrain = 32;
        blocks.resize(used.begin < used.end ? static_cast<std::size_t>(used.end) : 0);
        forRange(step, used, kGrain, [&](int first, int last) {
            kernels.prepare(source, lanes.data(), blocks.data(), first, last);
        });
    }
    void run(const StepContext& step, const Bodies& bodies, BlockRange range, int grain,
             PassKind kind) const {
        forRange(step, range, grain, [&](int first, int last) {
            kernels.passes[static_cast<std::size_t>(kind)](bodies, pass, lanes.data(), blocks.data(), first,
                                                           last);
        });
    }
    /// Stores impulses in World::contacts.
    void store(const StepContext& step) const {
        auto* contacts = reinterpret_cast<Float4*>(step.world.contacts.data());
        forRange(step, used, kBlockGrain, [&](int first, int last) {
            kernels.store(contacts, lanes.data(), blocks.data(), first, last);
        });
    }
};

/// Both kinds of contacts: between dynamic bodies, and with static or kinematic bodies.
template <class Bodies>
struct ContactSets {
    ContactSet<typename Bodies::TwoBlock, Bodies> two;
    ContactSet<typename Bodies::FixedBlock, Bodies> fixed;
};

template <class Bodies>
ContactSets<Bodies> contactsOf(const StepContext& step, const GroupKernels<Bodies>& kernels) {
    Workspace& work = step.work;
    const std::size_t hasFriction = step.runs(Effect::Friction) ? 1 : 0;
    const ContactRanges used = blocksOf(work, !Bodies::kRotate);
    return {
        {kernels.two[hasFriction], work.two.lanes, work.two.template blocksOf<Bodies>(), used.two},
        {kernels.fixed[hasFriction], work.fixed.lanes, work.fixed.template blocksOf<Bodies>(), used.fixed}};
}

}  // namespace plumb::physics
