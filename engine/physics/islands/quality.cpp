#include "physics/islands/quality.hpp"

#include <algorithm>
#include <array>

#include "physics/islands/hold_tolerance.hpp"
#include "physics/islands/lever_arms.hpp"
#include "physics/islands/sleeping.hpp"
#include "physics/islands/substep_estimate.hpp"

namespace plumb::physics {

namespace {

/// Kinds of islands that are solved with equal parameters: by quality and lever-arm level.
constexpr std::size_t kKinds = (kMaxQuality + 1) * (kMaxLeverage + 1);

void addGroup(Workspace& work, std::size_t kind, int bodies) {
    SolveGroup& group = work.groups.emplace_back();
    group.quality = static_cast<Quality>(kind % (kMaxQuality + 1));
    group.substeps = substepsOf(group.quality);
    group.iterations = 1 << kind / (kMaxQuality + 1);
    group.bodies = bodies;
}

void addGuesses(World& world, Workspace& work) {
    estimateSubsteps(world, work);
    for (const std::uint32_t body : world.awake) {
        const std::uint32_t root = work.roots[body];
        std::uint32_t& quality = work.bodyScratch[root];
        const auto extra = static_cast<std::uint32_t>(extraQuality(work.estimate[root]));
        quality = std::min(quality + extra, static_cast<std::uint32_t>(kMaxQuality));
        work.estimate[root].bodies = 0.0f;  // done
    }
}

/// Quality of each body, equal within an island: work.bodyScratch.
void judgeIslands(World& world, Workspace& work) {
    std::vector<std::uint32_t>& qualities = work.bodyScratch;
    qualities.assign(world.bodies.size(), static_cast<std::uint32_t>(world.settings.quality));
    for (const std::uint32_t body : world.awake) {
        std::uint32_t& best = qualities[work.roots[body]];
        const Quality wish = std::max(world.settings.quality, wishOf(world, body));
        best = std::max(best, static_cast<std::uint32_t>(wish));
    }
    if (world.settings.automaticQuality) addGuesses(world, work);
    for (const std::uint32_t body : world.awake) qualities[body] = qualities[work.roots[body]];
}

void addLeverages(World& world, Workspace& work) {
    judgeLeverages(world, work);
    for (const std::uint32_t body : world.awake)
        work.bodyScratch[body] += work.leverageOf[work.roots[body]] * (kMaxQuality + 1u);
}

void sortByIsland(World& world, Workspace& work) {
    findRoots(world, work);
    world.settings.tolerance > 0.0f ? holdTolerance(world, work) : judgeIslands(world, work);
    if (hasLeverage(world, work)) addLeverages(world, work);
    const std::vector<std::uint32_t>& kinds = work.bodyScratch;
    // Counting sort: count the bodies of each kind, find where each kind begins, then place the bodies.
    std::array<int, kKinds> counts{}, begins{};
    std::array<std::uint8_t, kKinds> groups{};
    for (const std::uint32_t body : world.awake) ++counts[kinds[body]];
    int total = 0;
    for (std::size_t kind = 0; kind < kKinds; ++kind) {
        begins[kind] = total;
        total += counts[kind];
        groups[kind] = static_cast<std::uint8_t>(work.groups.size());
        if (counts[kind] > 0) addGroup(work, kind, counts[kind]);
    }
    if (work.groups.size() == 1) return;
    work.solveOrder.resize(world.awake.size());
    work.groupOf.resize(world.bodies.size());
    for (const std::uint32_t body : world.awake) {
        const std::size_t kind = kinds[body];
        work.groupOf[body] = groups[kind];
        work.solveOrder[static_cast<std::size_t>(begins[kind]++)] = body;
    }
}

}  // namespace

void sortByQuality(World& world, Workspace& work) {
    work.groups.clear();
    work.solveOrder.clear();
    const bool holds = world.settings.tolerance > 0.0f;
    if (!holds && !world.bodies.substepControllers.empty()) world.bodies.substepControllers.clear();
    const bool alike = world.qualityCallers == 0 && !world.settings.automaticQuality && !holds;
    if (alike && !hasLeverage(world, work)) {
        addGroup(work, world.settings.quality, static_cast<int>(world.awake.size()));
    } else {
        sortByIsland(world, work);
    }
}

}  // namespace plumb::physics
