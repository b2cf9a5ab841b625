#include "physics/islands/quality.hpp"

#include <algorithm>
#include <bit>
#include <numeric>

#include "physics/edits.hpp"
#include "physics/islands/sleeping.hpp"
#include "physics/trees/joint_tree_solver.hpp"

namespace plumb::physics {

namespace {

/// Returns one level for a value above a limit, and one more for each further `factor`, up to three.
int stepsAbove(float value, float limit, float factor) {
    int steps = 0;
    for (; steps < 3 && value > limit; limit *= factor) ++steps;
    return steps;
}

/// Number of kinds of islands that are solved with equal parameters: by quality, with or without rotation.
constexpr std::size_t kKindsWithRotation = kMaxQuality + 1;
constexpr std::size_t kContactKinds = 2 * kKindsWithRotation;

void addGroup(Workspace& work, std::size_t kind, int bodies) {
    SolveGroup& group = work.groups.emplace_back();
    group.withoutRotation = kind >= kKindsWithRotation;
    group.quality = static_cast<Quality>(kind % kKindsWithRotation);
    group.substeps = substepsOf(group.quality);
    group.bodies = bodies;
}

/// Computes the quality of each body, equal within an island: work.bodyScratch.
void judgeIslands(World& world, Workspace& work) {
    std::vector<std::uint32_t>& qualities = work.bodyScratch;
    qualities.assign(world.bodies.size(), static_cast<std::uint32_t>(world.settings.quality));
    for (const std::uint32_t body : world.awake) {
        std::uint32_t& best = qualities[work.roots[body]];
        const Quality wish = std::max(world.settings.quality, requestedQualityOf(world, body));
        best = std::max(best, static_cast<std::uint32_t>(wish));
    }
    if (world.settings.automaticQuality) {
        estimateSubsteps(world, work);
        for (const std::uint32_t body : world.awake) {
            const std::uint32_t root = work.roots[body];
            const auto extra = static_cast<std::uint32_t>(extraQuality(work.estimate[root]));
            qualities[root] = std::min(qualities[root] + extra, static_cast<std::uint32_t>(kMaxQuality));
            work.estimate[root].bodies = 0.0f;  // marks the estimate as used
        }
    }
    for (const std::uint32_t body : world.awake) qualities[body] = qualities[work.roots[body]];
}

/// True if some awake bodies can be solved without rotation although others rotate.
bool mixesRotation(const StepContext& step) {
    const Manifest& manifest = step.world.manifest;
    const auto requesters = [&](Effect effect) {
        return manifest.requesters[static_cast<std::size_t>(effect)];
    };
    const bool pinned = (manifest.pinnedOn & Manifest::bit(Effect::Rotation)) != 0;
    return step.runs(Effect::Rotation) && !pinned &&
           requesters(Effect::Rotation) < requesters(Effect::Continuous);
}

/// Gives all islands that a group of soft bodies may push the same quality, so that they are solved together.
void addSoftGroups(Workspace& work, std::span<const std::uint32_t> awake) {
    SoftSurroundings& around = work.softSurroundings;
    for (const SoftGroup& group : around.groups) {
        auto quality = static_cast<std::uint32_t>(std::bit_width(static_cast<unsigned>(group.substeps - 1)));
        const auto forRoots = [&](auto&& act) {
            for (const SoftObstacle& obstacle : group.obstacles.of(around.obstacles)) {
                if (obstacle.isPushed) act(work.bodyScratch[work.roots[obstacle.body]]);
            }
        };
        forRoots([&](std::uint32_t other) { quality = std::max(quality, other); });
        forRoots([&](std::uint32_t& own) { own = quality; });
    }
    for (const std::uint32_t body : awake) work.bodyScratch[body] = work.bodyScratch[work.roots[body]];
}

/// Marks islands that the kernels without rotation cannot solve: with a body that can rotate or has joints,
/// with bounces, rolling resistance or soft bodies nearby. Kinematic bodies count as rotating.
void findRotating(StepContext& step) {
    const World& world = step.world;
    Workspace& work = step.work;
    work.needsRotation.assign(world.bodies.size(), 0);
    for (const std::uint32_t body : world.awake) {
        const BodyInfo& info = world.bodies.info[body];
        if (info.kind != BodyKind::Dynamic || info.firstJoint != kNone || (info.flags & kFixedRotation) == 0)
            work.needsRotation[work.roots[body]] = 1;
    }
    for (const SoftObstacle& obstacle : work.softSurroundings.obstacles) {
        if (step.runs(Effect::SoftBodies) && obstacle.isPushed)
            work.needsRotation[work.roots[obstacle.body]] = 1;
    }
    if (!step.runs(Effect::Restitution) && !step.runs(Effect::Rolling)) return;
    for (std::size_t i = 0; i < work.contactKeys.size(); ++i) {
        const Contact& contact = world.contacts[i];
        if (pushes(work.contactKeys[i]) && (contact.bounciness > 0.0f || contact.rollingResistance > 0.0f))
            work.needsRotation[work.roots[contact.bodyB]] = 1;
    }
}

void sortByIsland(StepContext& step) {
    World& world = step.world;
    Workspace& work = step.work;
    const bool judges = world.qualityCallers != 0 || world.settings.automaticQuality;
    // A division by rotation alone must not rebuild islands, which would change when bodies fall asleep.
    findRoots(step, judges || world.settings.tolerance > 0.0f);
    if (world.settings.tolerance > 0.0f) {
        holdTolerance(world, work);
    } else if (judges) {
        judgeIslands(world, work);
    } else {
        work.bodyScratch.assign(world.bodies.size(), static_cast<std::uint32_t>(world.settings.quality));
    }
    if (!work.softSurroundings.obstacleOf.empty()) addSoftGroups(work, world.awake);
    std::vector<std::uint32_t>& kinds = work.bodyScratch;
    if (mixesRotation(step)) {
        findRotating(step);
        for (const std::uint32_t body : world.awake)
            if (work.needsRotation[work.roots[body]] == 0) kinds[body] += kKindsWithRotation;
    }
    // Counting sort by kind: counts the bodies, computes the start of each kind, then stores the bodies.
    std::array<int, kContactKinds> counts{}, begins{};
    std::array<std::uint8_t, kContactKinds> groups{};
    for (const std::uint32_t body : world.awake) ++counts[kinds[body]];
    int total = 0;
    for (std::size_t kind = 0; kind < kContactKinds; ++kind) {
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
        const BodyMass& mass = world.bodies.mass[body];
        // Trees are solved accurately at any quality.
        if (mass.inverseMass == 0.0f || isInTree(world, work, body)) continue;
        const std::uint32_t root = work.roots[body];
        const float depth = dot(world.bodies.pose[body].centre - world.bodies.pose[root].centre, down);
        SubstepEstimate& island = work.estimate[root];
        island.lightest = std::min(island.lightest, mass.mass);
        island.heaviest = std::max(island.heaviest, mass.mass);
        island.lowest = std::min(island.lowest, depth);
        island.highest = std::max(island.highest, depth);
        island.size += world.bodies.info[body].core;
        island.bodies += 1.0f;
        forJointsOf(world, body, [&](std::uint32_t) { island.joints += 0.5f; });  // a half for each body
    }
}

void findRoots(const StepContext& step, bool exact) {
    World& world = step.world;
    Workspace& work = step.work;
    if (work.rootsKnown) return;
    if (world.islandsStale && exact) rebuildIslands(world, step.pool);
    work.roots.resize(world.bodies.size());
    std::iota(work.roots.begin(), work.roots.end(), 0u);
    // Only lookups without path compression, which writes to the forest, run on several threads.
    const auto isFar = [&](std::size_t i) {
        const std::uint32_t body = world.awake[i];
        const BodyInfo& info = world.bodies.info[body];
        if (info.kind != BodyKind::Dynamic) return false;
        work.roots[body] = info.island;
        return world.bodies.info[info.island].island != info.island;
    };
    forEachIf(step, world.awake.size(), isFar,
              [&](std::uint32_t i) { work.roots[world.awake[i]] = islandOf(world, world.awake[i]); });
    work.rootsKnown = !world.islandsStale;
}

void sortByQuality(StepContext& step) {
    World& world = step.world;
    Workspace& work = step.work;
    work.groups.clear();
    work.solveOrder.clear();
    const bool holds = world.settings.tolerance > 0.0f;
    if (!holds && !world.bodies.substepControllers.empty()) world.bodies.substepControllers.clear();
    const bool alike = work.softSurroundings.obstacleOf.empty() && world.qualityCallers == 0 &&
                       !world.settings.automaticQuality && !holds;
    if (alike && !mixesRotation(step)) {
        addGroup(work, static_cast<std::size_t>(world.settings.quality),
                 static_cast<int>(world.awake.size()));
    } else {
        sortByIsland(step);
    }
    if (!step.isWithoutRotation()) return;
    for (SolveGroup& group : work.groups) group.withoutRotation = true;
}

}  // namespace plumb::physics
