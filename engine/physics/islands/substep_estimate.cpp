#include <algorithm>
#include <numeric>

#include "physics/islands/quality.hpp"
#include "physics/islands/sleeping.hpp"
#include "physics/model/edits.hpp"
#include "physics/stages.hpp"
#include "physics/trees/joint_tree_solver.hpp"
#include "physics/tuning.hpp"

namespace plumb::physics {

namespace {

/// One level for a value above a limit, and one more for each `factor` above it, up to three: each level
/// reduces errors three to four times.
int stepsAbove(float value, float limit, float factor) {
    int steps = 0;
    for (; steps < 3 && value > limit; limit *= factor) ++steps;
    return steps;
}

void addTo(SubstepEstimate& island, const World& world, const Workspace& work, std::uint32_t body,
           std::uint32_t root, Vec2 down) {
    const BodyMass& mass = world.bodies.mass[body];
    // Trees are solved accurately at any quality.
    if (mass.inverseMass == 0.0f || isInTree(world, work, body)) return;
    const float depth = dot(world.bodies.pose[body].centre - world.bodies.pose[root].centre, down);
    island.lightest = std::min(island.lightest, mass.mass);
    island.heaviest = std::max(island.heaviest, mass.mass);
    island.lowest = std::min(island.lowest, depth);
    island.highest = std::max(island.highest, depth);
    island.size += world.bodies.info[body].core;
    island.bodies += 1.0f;
    forJointsOf(world, body, [&](std::uint32_t) { island.joints += 0.5f; });  // each body adds a half
}

}  // namespace

int extraQuality(const SubstepEstimate& island) {
    if (island.bodies == 0.0f) return 0;
    const float layers =
        (island.highest - island.lowest) * island.bodies / std::max(2.0f * island.size, 1e-6f);
    return std::max({stepsAbove(island.heaviest, kHeavyRatio * island.lightest, kMinGain),
                     stepsAbove(layers, kHighStack, kHigherStack),
                     stepsAbove(island.joints, kManyJoints, kManyMore)});
}

void estimateSubsteps(World& world, Workspace& work) {
    const Vec2 gravity = world.settings.gravity;
    const Vec2 down = lengthSquared(gravity) > 0.0f ? normalized(gravity) : Vec2{};
    work.estimate.assign(world.bodies.size(), SubstepEstimate{});
    for (const std::uint32_t body : world.awake) {
        const std::uint32_t root = work.roots[body];
        addTo(work.estimate[root], world, work, body, root, down);
    }
}

void findRoots(const StepContext& step, bool exact) {
    World& world = step.world;
    Workspace& work = step.work;
    if (work.rootsKnown) return;
    if (world.islandsStale && exact) rebuildIslands(world, step.pool);
    work.roots.resize(world.bodies.size());
    std::iota(work.roots.begin(), work.roots.end(), 0u);
    // Looking far shortens the way for the next one, which is not for several threads.
    const auto isFar = [&](std::size_t i) {
        const std::uint32_t body = world.awake[i];
        const BodyInfo& info = world.bodies.info[body];
        if (info.kind != BodyKind::Dynamic) return false;
        work.roots[body] = info.island;
        return world.bodies.info[info.island].island != info.island;
    };
    forThose(step, world.awake.size(), isFar,
             [&](std::uint32_t i) { work.roots[world.awake[i]] = islandOf(world, world.awake[i]); });
    work.rootsKnown = !world.islandsStale;
}

}  // namespace plumb::physics
