#include <algorithm>

#include "box_physics/queries/candidates.hpp"
#include "box_physics/stages.hpp"

namespace plumb::box_physics {

namespace {

constexpr int kMostCellsOfMover = 64;

/// All four compared whatever the first says: most pairs are apart, and which side says so cannot be guessed.
bool overlaps(const AABB& a, const AABB& b) {
    const int x = static_cast<int>(a.max.x >= b.min.x) & static_cast<int>(a.min.x <= b.max.x);
    const int y = static_cast<int>(a.max.y >= b.min.y) & static_cast<int>(a.min.y <= b.max.y);
    return (x & y) != 0;
}

/// True when the two bodies have anything to do with each other in this step.
bool mayMeet(const StepContext& step, std::uint32_t i, std::uint32_t j) {
    const Bodies& b = step.world.bodies;
    if ((b.layers[i] & b.mask[j]) == 0 || (b.layers[j] & b.mask[i]) == 0) return false;
    if (((b.flags[i] | b.flags[j]) & kTrigger) != 0) return (step.effects & kTriggers) != 0;
    const bool pushable = b.kind[i] == BodyKind::Dynamic || b.kind[j] == BodyKind::Dynamic;
    return pushable && (step.effects & kContacts) != 0;
}

void addPair(StepContext& step, std::uint32_t i, std::uint32_t j) {
    if (mayMeet(step, i, j)) step.world.work.unsortedPairs.push_back({std::min(i, j), std::max(i, j)});
}

void pairMovers(StepContext& step) {
    Workspace& work = step.world.work;
    const CellGrid& grid = work.movingGrid;
    for (std::size_t s = 0; s < grid.slotCount(); ++s) {
        const auto slot = grid.slot(s);
        for (std::size_t i = 0; i + 1 < slot.size(); ++i) {
            const CellEntry one = slot[i];
            for (std::size_t j = i + 1; j < slot.size(); ++j) {
                const CellEntry& other = slot[j];
                if (!overlaps(one.bounds, other.bounds) || other.x != one.x || other.y != one.y) continue;
                if (grid.isFirstShared(one.bounds, other.bounds, one.x, one.y)) {
                    addPair(step, one.body, other.body);
                }
            }
        }
    }
}

void pairLargeMovers(StepContext& step, std::span<const std::uint32_t> large) {
    const Workspace& work = step.world.work;
    for (const std::uint32_t i : large) {
        for (const std::uint32_t j : work.movers) {
            const bool otherLarge = std::binary_search(large.begin(), large.end(), j);
            if (i == j || (otherLarge && j < i) || !overlaps(work.bounds[i], work.bounds[j])) continue;
            addPair(step, i, j);
        }
    }
}

/// By a, then by b: counting over a, then the few pairs of one body by hand.
void sortPairs(Workspace& work, std::size_t bodies) {
    work.counts.assign(bodies + 1, 0);
    for (const Pair& pair : work.unsortedPairs) ++work.counts[pair.a + 1];
    for (std::size_t i = 1; i < work.counts.size(); ++i) work.counts[i] += work.counts[i - 1];
    work.pairs.resize(work.unsortedPairs.size());
    for (const Pair& pair : work.unsortedPairs) work.pairs[work.counts[pair.a]++] = pair;
    std::size_t from = 0;
    for (std::size_t a = 0; a < bodies; ++a) {
        const std::size_t to = work.counts[a];  // moved on to the end by the line that placed them
        const auto first = work.pairs.begin();
        if (to - from > 1) {
            std::sort(first + static_cast<std::ptrdiff_t>(from), first + static_cast<std::ptrdiff_t>(to),
                      [](const Pair& x, const Pair& y) { return x.b < y.b; });
        }
        from = to;
    }
}

}  // namespace

void findPairs(StepContext& step) {
    Workspace& work = step.world.work;
    refreshFixedGrid(step.world);
    work.unsortedPairs.clear();
    work.largeMovers.clear();
    const float size = cellSizeFor(work.movers, work.bounds);
    work.movingGrid.build(work.movers, work.bounds, size, kMostCellsOfMover, work.largeMovers);
    pairMovers(step);
    pairLargeMovers(step, work.largeMovers);
    for (const std::uint32_t mover : work.movers) {
        forEachFixed(step.world, work.bounds[mover],
                     [&](std::uint32_t fixed) { addPair(step, mover, fixed); });
    }
    sortPairs(work, step.world.bodies.size());
}

}  // namespace plumb::box_physics
