#pragma once

#include <bit>

#include "physics/solver/softness.hpp"
#include "physics/stages.hpp"

namespace plumb::physics {

// How passes over the bodies and constraints of a group are shared out.

inline constexpr int kBlockGrain = 24;
inline constexpr int kBodyGrain = 1024;
inline constexpr int kMostIterations = 64;
inline constexpr float kGroundStiffness =
    2.0f;  ///< ratio to Settings::contactStiffness: it does not give way

/// @param stiffness  ratio to Settings::contactStiffness
inline ContactPass contactPass(const Settings& settings, float h, float stiffness) {
    ContactPass pass;
    pass.substepRate = 1.0f / h;
    pass.softness = softness(stiffness * settings.contactStiffness / h, settings.contactDampingRatio, h);
    pass.pushSpeed = settings.pushSpeed;
    pass.deepPushRate = settings.deepPushRate;
    return pass;
}

/// Runs `act(begin, end)` over begin..end-1, in pieces.
template <class Act>
void forRange(const StepContext& step, int begin, int end, int grain, Act&& act) {
    forPieces(step, end - begin, grain, [&](int first, int last, int) { act(begin + first, begin + last); });
}

template <class Act>
void forBodies(const StepContext& step, const SolveGroup& group, Act&& act) {
    forRange(step, group.begin, group.end, kBodyGrain, act);
}

/// Runs `act(colour, grain)` for each of these colours: who found none first, one after the other.
template <class Act>
void forColours(std::uint64_t colours, Act&& act) {
    if ((colours >> kOverflow & 1) != 0) act(int{kOverflow}, 1 << 30);
    for (std::uint64_t rest = colours & ((std::uint64_t{1} << kColours) - 1); rest != 0; rest &= rest - 1)
        act(std::countr_zero(rest), kBlockGrain);
}

/// Contacts of one kind, and how they are pushed.
template <class Block, class Bodies>
struct ContactSet {
    const ContactKernels<Block, Bodies>& kernels;
    const std::vector<BlockLanes>& lanes;
    std::vector<Block>& blocks;
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
    /// Impulses back to the contacts.
    void store(StepContext& step) const {
        auto* contacts = reinterpret_cast<Float4*>(step.world.contacts.data());
        forRange(step, 0, static_cast<int>(lanes.size()), kBlockGrain, [&](int begin, int end) {
            kernels.store(contacts, lanes.data(), blocks.data(), begin, end);
        });
    }
};

/// Both kinds: between bodies that can be pushed, and with those that cannot.
template <class Two, class Fixed>
struct ContactSets {
    Two two;
    Fixed fixed;

    /// @param h  s: of the substeps of the group that comes next
    void startGroup(const Settings& settings, float h) {
        two.pass = contactPass(settings, h, 1.0f);
        fixed.pass = contactPass(settings, h, kGroundStiffness);
    }

    /// Runs `act(set, begin, end)` over the blocks of a colour.
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
