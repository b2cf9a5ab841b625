#pragma once

#include <algorithm>
#include <atomic>

#include "physics/world.hpp"

namespace plumb {
class TaskPool;
}

namespace plumb::physics {

/// Adds a new body to the list of awake bodies.
void addAwake(World& world, std::uint32_t body);
/// Adds a new sleeping body as a separate island.
void addAsleep(World& world, std::uint32_t body);
/// Removes a body that is destroyed or disabled from the list of awake bodies.
/// @pre the body is awake or static
void removeAwake(World& world, std::uint32_t body);

/// Wakes the whole island of a body; an awake body stays awake for at least another Settings::sleepTime.
void wake(World& world, std::uint32_t body);
void wakeAll(World& world);
/// Wakes a body and all bodies that touch it or have a joint with it.
void wakeTouching(World& world, std::uint32_t body);
/// Wakes a body that is about to move; if it was at rest, also bodies that touch it or have a joint with it.
void wakeForMotion(World& world, std::uint32_t body);
void sleepNow(World& world, std::uint32_t body);  ///< puts the whole island of a body to sleep

inline constexpr std::uint32_t kIslandToBe = kNone - 1;
/// Puts islands to sleep.
/// @param sleepingRoots  by body: kIslandToBe for the root of an island to put to sleep, else kNone
void sleepIslands(World& world, std::vector<std::uint32_t>& sleepingRoots);

/// Adds a joint to Joints::awake, unless it is never solved: a filter, or a joint of a disabled body.
void addAwakeJoint(World& world, std::uint32_t joint);
void removeAwakeJoint(World& world, std::uint32_t joint);

// Islands are a union-find forest: bodies connected by contacts or joints have the same root. After contacts
// or joints end, islands may be larger than necessary until the forest is rebuilt. Source: R. Tarjan,
// "Efficiency of a good but not linear set union algorithm", 1975 (path halving).

/// @param parent  returns a reference to the parent of an element (std::uint32_t&); a root is its own parent
template <class Parent>
std::uint32_t rootOf(Parent&& parent, std::uint32_t member) {
    using AtomicParent = std::atomic_ref<std::uint32_t>;
    for (;;) {
        const std::uint32_t next = AtomicParent{parent(member)}.load(std::memory_order_relaxed);
        const std::uint32_t after = AtomicParent{parent(next)}.load(std::memory_order_relaxed);
        if (next == after) return next;
        // Races are harmless: every thread writes an ancestor. joinTrees() changes roots atomically.
        AtomicParent{parent(member)}.store(after, std::memory_order_relaxed);
        member = after;
    }
}
/// Joins two trees. Thread-safe. The lower root remains the root, so the order does not matter.
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

inline std::uint32_t islandOf(World& world, std::uint32_t body) {
    return rootOf([&](std::uint32_t i) -> std::uint32_t& { return world.bodies.info[i].island; }, body);
}
inline void joinIslands(World& world, std::uint32_t a, std::uint32_t b) {
    joinTrees([&](std::uint32_t i) -> std::uint32_t& { return world.bodies.info[i].island; }, a, b);
}
/// Rebuilds the forest from the current contacts and joints.
/// @param pool  threads that share the work
void rebuildIslands(World& world, TaskPool* pool = nullptr);

}  // namespace plumb::physics
