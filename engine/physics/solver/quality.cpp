#include "physics/solver/quality.hpp"

#include <algorithm>
#include <array>

#include "physics/sleeping.hpp"
#include "physics/solver/grow_trees.hpp"
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

void addGroup(Workspace& work, int quality, int bodies) {
    SolveGroup& group = work.groups.emplace_back();
    group.quality = static_cast<Quality>(quality);
    group.substeps = substepsOf(group.quality);
    group.bodies = bodies;
}

std::uint32_t rootOf(World& world, std::uint32_t body) {
    return world.bodies.info[body].kind == BodyKind::Dynamic ? islandOf(world, body) : body;
}

/// One more for a value above a limit, and for each `factor` that it is above it, up to three: each makes
/// errors three to four times smaller.
int stepsAbove(float value, float limit, float factor) {
    int steps = 0;
    for (; steps < 3 && value > limit; limit *= factor) ++steps;
    return steps;
}

int extraQuality(const IslandHardness& island) {
    if (island.bodies == 0.0f) return 0;
    const float layers =
        (island.highest - island.lowest) * island.bodies / std::max(2.0f * island.size, 1e-6f);
    // Where the limits are: measured, so that hard cases keep to millimetres (plumb-accuracy-physics).
    return std::max({stepsAbove(island.heaviest, 10.0f * island.lightest, 3.0f),
                     stepsAbove(layers, 7.0f, 2.0f), stepsAbove(island.joints, 8.0f, 4.0f)});
}

void addTo(IslandHardness& island, const World& world, const Workspace& work, std::uint32_t body,
           std::uint32_t root, Vec2 down) {
    const BodyMass& mass = world.bodies.mass[body];
    // What only hangs in a tree is never hard.
    if (mass.inverseMass == 0.0f || isInTree(world, work, body)) return;
    const float depth = dot(world.bodies.pose[body].centre - world.bodies.pose[root].centre, down);
    island.lightest = std::min(island.lightest, mass.mass);
    island.heaviest = std::max(island.heaviest, mass.mass);
    island.lowest = std::min(island.lowest, depth);
    island.highest = std::max(island.highest, depth);
    island.size += world.bodies.info[body].core;
    island.bodies += 1.0f;
    for (std::uint32_t j = world.bodies.info[body].firstJoint; j != kNone;) {
        const Joint& joint = world.joints.hot[j];
        island.joints += 0.5f;  // the other half comes with its other body
        j = joint.bodyA == body ? joint.nextA : joint.nextB;
    }
}

/// The quality that all bodies of an island get, by its root: work.bodyScratch.
void judgeIslands(World& world, Workspace& work) {
    std::vector<std::uint32_t>& qualities = work.bodyScratch;
    const bool automatic = world.settings.automaticQuality;
    const Vec2 gravity = world.settings.gravity;
    const Vec2 down = lengthSquared(gravity) > 0.0f ? normalized(gravity) : Vec2{};
    std::vector<IslandHardness>& islands = work.hardness;
    islands.assign(automatic ? world.bodies.size() : 0, IslandHardness{});
    qualities.assign(world.bodies.size(), 0);
    for (const std::uint32_t body : world.awake) {
        const std::uint32_t root = rootOf(world, body);
        std::uint32_t& best = qualities[root];
        best = std::max(best, static_cast<std::uint32_t>(wishOf(world, body)));
        if (automatic) addTo(islands[root], world, work, body, root, down);
    }
    if (!automatic) return;
    for (const std::uint32_t body : world.awake) {
        const std::uint32_t root = rootOf(world, body);
        if (islands[root].bodies == 0.0f) continue;
        qualities[root] = std::min(qualities[root] + static_cast<std::uint32_t>(extraQuality(islands[root])),
                                   static_cast<std::uint32_t>(kMaxQuality));
        islands[root].bodies = 0.0f;  // done
    }
}

void sortByIsland(World& world, Workspace& work) {
    if (world.islandsStale) rebuildIslands(world);
    judgeIslands(world, work);
    const std::vector<std::uint32_t>& highest = work.bodyScratch;  // by root
    // A counting sort: how many of each quality, where each begins, then everyone to their place.
    std::array<int, kMaxQuality + 1> counts{}, begins{};
    std::array<std::uint8_t, kMaxQuality + 1> groups{};
    for (const std::uint32_t body : world.awake) ++counts[highest[rootOf(world, body)]];
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
        const std::size_t quality = highest[rootOf(world, body)];
        work.groupOf[body] = groups[quality];
        work.solveOrder[static_cast<std::size_t>(begins[quality]++)] = body;
    }
}

}  // namespace

void sortByQuality(World& world, Workspace& work) {
    work.groups.clear();
    work.solveOrder.clear();
    if (world.qualityCallers == 0 && !world.settings.automaticQuality) {
        addGroup(work, world.settings.quality, static_cast<int>(world.awake.size()));
    } else {
        sortByIsland(world, work);
    }
}

}  // namespace plumb::physics
