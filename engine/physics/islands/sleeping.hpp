#pragma once

#include <algorithm>
#include <atomic>

#include "physics/world.hpp"

namespace plumb {
class TaskPool;
}

namespace plumb::physics {

/// A new body that moves.
void addAwake(World& world, std::uint32_t body);
/// A new body that rests, as an island of its own.
void addAsleep(World& world, std::uint32_t body);
/// Takes a body that goes away out of the list.
/// @pre it is awake or can never be
void removeAwake(World& world, std::uint32_t body);

/// Wakes the whole island of a body; one that is awake stays so for another Settings::sleepTime.
void wake(World& world, std::uint32_t body);
void wakeAll(World& world);
/// Wakes everything that touches a body or is joined to it, and the body itself.
void wakeTouching(World& world, std::uint32_t body);
/// Wakes a body that is about to move; if it stood still, what lies on it and hangs from it too.
void wakeForMotion(World& world, std::uint32_t body);
void sleepNow(World& world, std::uint32_t body);

inline constexpr std::uint32_t kIslandToBe = kNone - 1;
/// Puts islands to sleep.
/// @param sleepingRoots  by body: kIslandToBe for the root of an island that goes to sleep, else kNone
void sleepIslands(World& world, std::vector<std::uint32_t>& sleepingRoots);

/// Does nothing for joints that no step has to solve: filters, and those of disabled bodies.
void addAwakeJoint(World& world, std::uint32_t joint);
void removeAwakeJoint(World& world, std::uint32_t joint);

// The forest of islands: what touches or is joined. Two bodies of one island have one root; islands may be
// larger than need be until the forest is made anew. Source: R. Tarjan, "Efficiency of a good but not linear
// set union algorithm", 1975 (path halving).

/// @param parent  gives the parent of a member, as std::uint32_t&; a root is its own
template <class Parent>
std::uint32_t rootOf(Parent&& parent, std::uint32_t member) {
    using AtomicParent = std::atomic_ref<std::uint32_t>;
    for (;;) {
        const std::uint32_t next = AtomicParent{parent(member)}.load(std::memory_order_relaxed);
        const std::uint32_t after = AtomicParent{parent(next)}.load(std::memory_order_relaxed);
        if (next == after) return next;
        // Of several threads the last writes an ancestor: only a joined root must not be overwritten.
        AtomicParent{parent(member)}.store(after, std::memory_order_relaxed);
        member = after;
    }
}
/// May be called by several threads at a time. The lower root stays one, whatever the order of joining.
template <class Parent>
void joinTrees(Parent&& parent, std::uint32_t a, std::uint32_t b) {
    for (;;) {
        a = rootOf(parent, a), b = rootOf(parent, b);
        if (a == b) return;
        std::uint32_t root = std::max(a, b);
        if (std::atomic_ref<std::uint32_t>{parent(root)}.compare_exchange_strong(root, std::min(a, b),
                                                                                 std::memory_order_relaxed))
            return;
    }
}

std::uint32_t islandOf(World& world, std::uint32_t body);
void joinIslands(World& world, std::uint32_t a, std::uint32_t b);
/// Forgets contacts and joints that ended.
/// @param pool  threads to share the work
void rebuildIslands(World& world, TaskPool* pool = nullptr);

}  // namespace plumb::physics
