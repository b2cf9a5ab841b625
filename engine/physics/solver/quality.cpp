#include "physics/solver/quality.hpp"

#include <algorithm>
#include <array>

#include "physics/sleeping.hpp"
#include "physics/workspace.hpp"

namespace plumb::physics {

namespace {

/// What a body, and its joints, ask for.
Quality wishOf(const World& world, std::uint32_t body) {
    Quality wish = std::max(world.bodies.info[body].quality, world.settings.quality);
    for (std::uint32_t j = world.bodies.info[body].firstJoint; j != kNone;) {
        const Joint& joint = world.joints.hot[j];
        wish = std::max(wish, joint.quality);
        j = joint.bodyA == body ? joint.nextA : joint.nextB;
    }
    return wish;
}

void addGroup(const World& world, Workspace& work, int quality, int bodies) {
    SolveGroup& group = work.groups.emplace_back();
    group.quality = static_cast<Quality>(quality);
    group.substeps = world.settings.solver == SolverKind::SoftStep ? substepsOf(group.quality) : 1;
    group.bodies = bodies;
}

void sortByIsland(World& world, Workspace& work) {
    if (world.islandsStale) rebuildIslands(world);
    std::vector<std::uint32_t>& highest = work.bodyScratch;  // by root
    highest.assign(world.bodies.size(), 0);
    const auto rootOf = [&](std::uint32_t body) {
        return world.bodies.info[body].kind == BodyKind::Dynamic ? islandOf(world, body) : body;
    };
    for (const std::uint32_t body : world.awake) {
        std::uint32_t& best = highest[rootOf(body)];
        best = std::max(best, static_cast<std::uint32_t>(wishOf(world, body)));
    }
    // A counting sort: how many of each quality, where each begins, then everyone to their place.
    std::array<int, kMaxQuality + 1> counts{}, begins{};
    std::array<std::uint8_t, kMaxQuality + 1> groups{};
    for (const std::uint32_t body : world.awake) ++counts[highest[rootOf(body)]];
    int total = 0;
    for (std::size_t q = 0; q < counts.size(); ++q) {
        begins[q] = total;
        total += counts[q];
        groups[q] = static_cast<std::uint8_t>(work.groups.size());
        if (counts[q] > 0) addGroup(world, work, static_cast<int>(q), counts[q]);
    }
    if (work.groups.size() == 1) return;
    work.solveOrder.resize(world.awake.size());
    work.groupOf.resize(world.bodies.size());
    for (const std::uint32_t body : world.awake) {
        const std::size_t quality = highest[rootOf(body)];
        work.groupOf[body] = groups[quality];
        work.solveOrder[static_cast<std::size_t>(begins[quality]++)] = body;
    }
}

}  // namespace

void sortByQuality(World& world, Workspace& work) {
    work.groups.clear();
    work.solveOrder.clear();
    if (world.qualityCallers == 0 && !world.settings.automaticQuality) {
        addGroup(world, work, world.settings.quality, static_cast<int>(world.awake.size()));
    } else {
        sortByIsland(world, work);
    }
}

}  // namespace plumb::physics
