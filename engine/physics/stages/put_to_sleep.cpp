#include <algorithm>
#include <cmath>

#include "physics/islands/quality.hpp"
#include "physics/islands/sleeping.hpp"
#include "physics/islands/substep_controller.hpp"
#include "physics/model/joints.hpp"
#include "physics/stages.hpp"

namespace plumb::physics {

namespace {

/// True if the island of a body may sleep, by Workspace::bodyScratch.
bool maySleep(const StepContext& step, std::uint32_t body) {
    return isDynamic(step.world, body) && step.work.bodyScratch[step.work.roots[body]] != kNone;
}
void keepAwake(StepContext& step, std::uint32_t body) {
    if (isDynamic(step.world, body)) step.work.bodyScratch[step.work.roots[body]] = kNone;
}

/// Keeps bodies awake that a moving platform carries or pulls; asleep they could be left in the air.
void keepCarriedAwake(StepContext& step) {
    const World& world = step.world;
    const auto moves = [&](std::uint32_t body) {
        const BodyInfo& info = world.bodies.info[body];
        return info.kind == BodyKind::Kinematic && (info.flags & kMoved) != 0;
    };
    const auto keepBoth = [&](std::uint32_t a, std::uint32_t b) {
        if (moves(a) || moves(b)) keepAwake(step, moves(a) ? b : a);
    };
    const std::vector<std::uint16_t>& keys = step.work.contactKeys;
    const auto carries = [&](std::size_t i) {
        if (i < keys.size() && (keys[i] & kKeyFixed) == 0) return false;
        const Contact& contact = world.contacts[i];
        return (contact.flags & kTouching) != 0 && (moves(contact.bodyA) || moves(contact.bodyB));
    };
    forEachIf(step, world.contacts.size(), carries,
              [&](std::uint32_t i) { keepBoth(world.contacts[i].bodyA, world.contacts[i].bodyB); });
    for (const std::uint32_t j : world.joints.awake)
        keepBoth(world.joints.hot[j].bodyA, world.joints.hot[j].bodyB);
}

/// Keeps bodies awake that are slowly pushed out of an initial overlap (initial_overlaps.cpp).
void keepOverlappingAwake(StepContext& step) {
    const World& world = step.world;
    if (world.initialOverlaps.empty()) return;
    const auto overlaps = [&](std::size_t i) {
        return (world.contacts[i].flags & (kTouching | kInitialOverlap)) == (kTouching | kInitialOverlap);
    };
    forEachIf(step, world.contacts.size(), overlaps, [&](std::uint32_t i) {
        keepAwake(step, world.contacts[i].bodyA);
        keepAwake(step, world.contacts[i].bodyB);
    });
}

/// Keeps bodies awake that move because joint errors close, which leaves no velocity.
void keepClosingAwake(StepContext& step) {
    const World& world = step.world;
    const auto moved = [&](std::uint32_t body) {
        const std::int32_t slot = step.work.slots[body];
        if (slot < 0 || !isDynamic(world, body)) return false;
        const Float4& way = step.work.deltaPosition[static_cast<std::size_t>(slot)];
        const BodyInfo& info = world.bodies.info[body];
        return length(Vec2{way.x, way.y}) + std::fabs(way.z) * info.reach > info.sleepSpeed * step.dt;
    };
    for (const std::uint32_t j : world.joints.awake) {
        const std::uint32_t a = world.joints.hot[j].bodyA, b = world.joints.hot[j].bodyB;
        if ((!maySleep(step, a) && !maySleep(step, b)) || (!moved(a) && !moved(b))) continue;
        const std::uint32_t own = isDynamic(world, a) ? a : b;
        const JointReading reading = readingOf(world, idOfJoint(world, j));
        const float turned = reading.angularSeparation * world.bodies.info[own].reach;
        if (std::max(reading.separation, turned) > world.settings.slop) keepAwake(step, own);
    }
}

/// Keeps islands awake whose quality is being raised, because asleep they would keep their overlap.
void keepStrainedAwake(StepContext& step) {
    if (step.world.bodies.substepControllers.empty()) return;
    for (const std::uint32_t body : step.world.awake) {
        if (isAtWork(step.world.bodies.substepControllers[body])) keepAwake(step, body);
    }
}

}  // namespace

void putToSleep(StepContext& step) {
    World& world = step.world;
    if (world.islandsStale) world.islandsAge += step.dt;
    if (!step.work.sleepy) return;
    if (world.islandsAge >= kRebuildPart * world.settings.sleepTime) rebuildIslands(world, step.pool);
    // An island falls asleep when all its bodies have been at rest for Settings::sleepTime.
    std::vector<std::uint32_t>& verdict = step.work.bodyScratch;  // indexed by root
    verdict.assign(world.bodies.size(), kIslandToBe);
    step.work.rootsKnown = false;  // hits may have joined islands since findRoots()
    findRoots(step, false);
    const auto restless = [&](std::size_t i) {
        return isDynamic(world, world.awake[i]) &&
               world.bodies.motion[world.awake[i]].restTime < world.settings.sleepTime;
    };
    forEachIf(step, world.awake.size(), restless, [&](std::uint32_t i) { keepAwake(step, world.awake[i]); });
    if (world.manifest.runs(Effect::Kinematics)) keepCarriedAwake(step);
    keepOverlappingAwake(step);
    keepClosingAwake(step);
    keepStrainedAwake(step);
    const auto sleepsNow = [&](std::uint32_t body) { return maySleep(step, body); };
    if (std::any_of(world.awake.begin(), world.awake.end(), sleepsNow)) sleepIslands(world, verdict);
}

}  // namespace plumb::physics
