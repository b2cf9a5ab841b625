#include "physics/solver/quality.hpp"

#include <algorithm>
#include <array>

#include "physics/sleeping.hpp"
#include "physics/solver/hardness.hpp"
#include "physics/solver/hold_tolerance.hpp"

namespace plumb::physics {

namespace {

void addGroup(Workspace& work, int quality, int bodies) {
    SolveGroup& group = work.groups.emplace_back();
    group.quality = static_cast<Quality>(quality);
    group.substeps = substepsOf(group.quality);
    group.bodies = bodies;
}

void addGuesses(World& world, Workspace& work) {
    findHardness(world, work);
    for (const std::uint32_t body : world.awake) {
        const std::uint32_t root = rootOf(world, body);
        std::uint32_t& quality = work.bodyScratch[root];
        const auto extra = static_cast<std::uint32_t>(extraQuality(work.hardness[root]));
        quality = std::min(quality + extra, static_cast<std::uint32_t>(kMaxQuality));
        work.hardness[root].bodies = 0.0f;  // done
    }
}

/// The quality that each body gets, the same for an island: work.bodyScratch.
void judgeIslands(World& world, Workspace& work) {
    std::vector<std::uint32_t>& qualities = work.bodyScratch;
    qualities.assign(world.bodies.size(), static_cast<std::uint32_t>(world.settings.quality));
    for (const std::uint32_t body : world.awake) {
        std::uint32_t& best = qualities[rootOf(world, body)];
        const Quality wish = std::max(world.settings.quality, wishOf(world, body));
        best = std::max(best, static_cast<std::uint32_t>(wish));
    }
    if (world.settings.automaticQuality) addGuesses(world, work);
    for (const std::uint32_t body : world.awake) qualities[body] = qualities[rootOf(world, body)];
}

void sortByIsland(World& world, Workspace& work) {
    if (world.islandsStale) rebuildIslands(world);
    world.settings.tolerance > 0.0f ? holdTolerance(world, work) : judgeIslands(world, work);
    const std::vector<std::uint32_t>& qualities = work.bodyScratch;
    // A counting sort: how many of each quality, where each begins, then everyone to their place.
    std::array<int, kMaxQuality + 1> counts{}, begins{};
    std::array<std::uint8_t, kMaxQuality + 1> groups{};
    for (const std::uint32_t body : world.awake) ++counts[qualities[body]];
    int total = 0;
    for (std::size_t q = 0; q < counts.size(); ++q) {
        begins[q] = total;
        total += counts[q];
        groups[q] = static_cast<std::uint8_t>(work.groups.size());
        if (counts[q] > 0) addGroup(work, static_cast<int>(q), counts[q]);
    }
    if (work.groups.size() == 1) return;
    work.solveOrder.resize(world.awake.size());
    work.groupOf.resize(world.bodies.size());
    for (const std::uint32_t body : world.awake) {
        const std::size_t quality = qualities[body];
        work.groupOf[body] = groups[quality];
        work.solveOrder[static_cast<std::size_t>(begins[quality]++)] = body;
    }
}

}  // namespace

void sortByQuality(World& world, Workspace& work) {
    work.groups.clear();
    work.solveOrder.clear();
    const bool holds = world.settings.tolerance > 0.0f;
    if (!holds && !world.bodies.efforts.empty()) world.bodies.efforts.clear();
    if (world.qualityCallers == 0 && !world.settings.automaticQuality && !holds) {
        addGroup(work, world.settings.quality, static_cast<int>(world.awake.size()));
    } else {
        sortByIsland(world, work);
    }
}

}  // namespace plumb::physics
