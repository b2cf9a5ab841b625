#pragma once

#include <bit>
#include <utility>

#include "physics/solver/softness.hpp"
#include "physics/stages.hpp"

namespace plumb::physics {

// Passes over the bodies and constraints of a group, distributed over threads.

inline constexpr int kBlockGrain = 8;
inline constexpr int kSequential = 1 << 30;  ///< as a grain: one piece
inline constexpr int kBodyGrain = 256;

/// @param h  s: substep
inline ContactPass contactPass(const Settings& settings, float h) {
    ContactPass pass;
    pass.substepRate = 1.0f / h;
    pass.softness = softness(settings.contactStiffness / h, settings.contactDampingRatio, h);
    pass.pushSpeed = settings.pushSpeed;
    pass.deepPushRate = settings.deepPushRate;
    return pass;
}

/// Runs `act(begin, end)` over begin..end-1, in pieces.
template <class Act>
void forRange(const StepContext& step, int begin, int end, int grain, Act&& act) {
    forPieces(step, end - begin, grain, [&](int first, int last, int) { act(begin + first, begin + last); });
}

/// Runs `act(n)` for the blocks begin..end-1.
template <class Act>
void forBlocks(const StepContext& step, int begin, int end, int grain, Act&& act) {
    forRange(step, begin, end, grain, [&](int first, int last) {
        for (int n = first; n < last; ++n) act(static_cast<std::size_t>(n));
    });
}

template <class Act>
void forBodies(const StepContext& step, const SolveGroup& group, Act&& act) {
    forRange(step, group.begin, group.end, kBodyGrain, act);
}

/// Runs `act(colour, grain)` for each of these colors: the overflow first, in one sequential piece.
template <class Act>
void forColours(std::uint64_t colours, Act&& act) {
    if ((colours >> kOverflow & 1) != 0) act(int{kOverflow}, kSequential);
    for (std::uint64_t rest = colours & ((std::uint64_t{1} << kColours) - 1); rest != 0; rest &= rest - 1)
        act(std::countr_zero(rest), kBlockGrain);
}

/// Number of blocks of groups with rotation, which come first: between dynamic bodies, and of fixed ones.
inline std::pair<std::int32_t, std::int32_t> blocksWithRotation(const Workspace& work) {
    std::pair<std::int32_t, std::int32_t> ends{0, 0};
    for (const SolveGroup& group : work.groups) {
        if (!group.withoutRotation)
            ends = {group.colours[kColours].contactEnd, group.colours[kColours].fixedEnd};
    }
    return ends;
}

/// Contacts of one kind, with their kernels and the parameters of a pass.
template <class Block, class Bodies>
struct ContactSet {
    const ContactKernels<Block, Bodies>& kernels;
    const std::vector<BlockLanes>& lanes;
    std::vector<Block>& blocks;
    int firstUsed = 0;  ///< the blocks before are those of the other kernels
    ContactPass pass{};

    void warmStart(const Bodies& bodies, int begin, int end) const {
        kernels.warmStart(bodies, lanes.data(), blocks.data(), begin, end);
    }
    void push(const Bodies& bodies, int begin, int end) const {
        kernels.push(bodies, pass, lanes.data(), blocks.data(), begin, end);
    }
    void relax(const Bodies& bodies, int begin, int end) const {
        kernels.relax(bodies, pass, lanes.data(), blocks.data(), begin, end);
    }
    /// Writes impulses back to the contacts.
    void store(StepContext& step) const {
        auto* contacts = reinterpret_cast<Float4*>(step.world.contacts.data());
        forRange(step, firstUsed, static_cast<int>(blocks.size()), kBlockGrain, [&](int first, int last) {
            kernels.store(contacts, lanes.data(), blocks.data(), first, last);
        });
    }
};

/// Both kinds of contacts: between dynamic bodies, and with static or kinematic ones.
template <class Two, class Fixed, class Bodies>
struct ContactSets {
    ContactSet<Two, Bodies> two;
    ContactSet<Fixed, Bodies> fixed;

    /// @param h  s: substep of the group that comes next
    void startGroup(const Settings& settings, float h) {
        two.pass = fixed.pass = contactPass(settings, h);
    }

    /// Runs `act(set, begin, end)` over the blocks of a color.
    template <class Act>
    void forBlocks(const StepContext& step, const ColourBlocks& blocks, int grain, Act&& act) const {
        forRange(step, blocks.contactBegin, blocks.contactEnd, grain,
                 [&](int begin, int end) { act(two, begin, end); });
        forRange(step, blocks.fixedBegin, blocks.fixedEnd, grain,
                 [&](int begin, int end) { act(fixed, begin, end); });
    }
    void store(StepContext& step) const {
        two.store(step);
        fixed.store(step);
    }
};

}  // namespace plumb::physics
