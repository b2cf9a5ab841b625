#include <algorithm>

#include "physics/islands/sleeping.hpp"
#include "physics/islands/substep_controller.hpp"
#include "physics/islands/substep_estimate.hpp"
#include "physics/stages.hpp"
#include "physics/tuning.hpp"

namespace plumb::physics {

namespace {

/// What a moving platform carries or pulls stays awake, however slow it is: it could be left in the air.
void keepCarriedAwake(StepContext& step, std::vector<std::uint32_t>& verdict) {
    World& world = step.world;
    const auto moves = [&](std::uint32_t body) {
        const BodyInfo& info = world.bodies.info[body];
        return info.kind == BodyKind::Kinematic && (info.flags & kMoved) != 0;
    };
    const auto keepAwake = [&](std::uint32_t a, std::uint32_t b) {
        if (!moves(a) && !moves(b)) return;
        const std::uint32_t carried = moves(a) ? b : a;
        if (world.bodies.info[carried].kind == BodyKind::Dynamic) verdict[step.work.roots[carried]] = kNone;
    };
    const std::vector<std::uint16_t>& keys = step.work.contactKeys;
    collectIf(step, world.contacts.size(), step.work.pieceFound, [&](std::size_t i) {
        if (i < keys.size() && (keys[i] & kKeyFixed) == 0) return false;
        const Contact& contact = world.contacts[i];
        return (contact.flags & kTouching) != 0 && (moves(contact.bodyA) || moves(contact.bodyB));
    });
    for (const std::uint32_t i : step.work.pieceFound)
        keepAwake(world.contacts[i].bodyA, world.contacts[i].bodyB);
    for (const std::uint32_t j : world.joints.awake)
        keepAwake(world.joints.hot[j].bodyA, world.joints.hot[j].bodyB);
}

/// What comes out of an overlap that it was put into (initial_overlaps.hpp) is slow, but not at rest.
void keepOverlappingAwake(StepContext& step, std::vector<std::uint32_t>& verdict) {
    World& world = step.world;
    if (world.initialOverlaps.empty()) return;
    collectIf(step, world.contacts.size(), step.work.pieceFound, [&](std::size_t i) {
        return (world.contacts[i].flags & (kTouching | kInitialOverlap)) == (kTouching | kInitialOverlap);
    });
    for (const std::uint32_t i : step.work.pieceFound) {
        for (const std::uint32_t body : {world.contacts[i].bodyA, world.contacts[i].bodyB}) {
            if (world.bodies.info[body].kind == BodyKind::Dynamic) verdict[step.work.roots[body]] = kNone;
        }
    }
}

/// What slept while it is too deep in something would stay there.
void keepStrainedAwake(StepContext& step, std::vector<std::uint32_t>& verdict) {
    const World& world = step.world;
    if (world.bodies.substepControllers.empty()) return;
    for (const std::uint32_t body : world.awake) {
        if (world.bodies.info[body].kind == BodyKind::Dynamic &&
            isAtWork(world.bodies.substepControllers[body]))
            verdict[step.work.roots[body]] = kNone;
    }
}

}  // namespace

void putToSleep(StepContext& step) {
    World& world = step.world;
    if (world.islandsStale) world.islandsAge += step.dt;
    if (!step.work.sleepy) return;
    if (world.islandsAge >= kRebuildPart * world.settings.sleepTime) rebuildIslands(world, step.pool);
    // An island sleeps when the most restless of its bodies has rested long enough.
    std::vector<std::uint32_t>& verdict = step.work.bodyScratch;  // by root
    verdict.assign(world.bodies.size(), kIslandToBe);
    step.work.rootsKnown = false;  // hits may have joined islands since
    findRoots(step, false);
    collectIf(step, world.awake.size(), step.work.pieceFound, [&](std::size_t i) {
        const std::uint32_t body = world.awake[i];
        return world.bodies.info[body].kind == BodyKind::Dynamic &&
               world.bodies.motion[body].restTime < world.settings.sleepTime;
    });
    for (const std::uint32_t i : step.work.pieceFound) verdict[step.work.roots[world.awake[i]]] = kNone;
    if (world.manifest.runs(Effect::Kinematics)) keepCarriedAwake(step, verdict);
    keepOverlappingAwake(step, verdict);
    keepStrainedAwake(step, verdict);
    const bool some = std::any_of(world.awake.begin(), world.awake.end(), [&](std::uint32_t body) {
        return world.bodies.info[body].kind == BodyKind::Dynamic && verdict[step.work.roots[body]] != kNone;
    });
    if (some) sleepIslands(world, verdict);
}

}  // namespace plumb::physics
