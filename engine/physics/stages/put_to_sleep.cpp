#include <algorithm>

#include "physics/islands/sleeping.hpp"
#include "physics/islands/substep_controller.hpp"
#include "physics/stages.hpp"

namespace plumb::physics {

namespace {

/// Part of Settings::sleepTime: contacts and joints that ended keep islands larger than need be for so long.
/// A rebuild looks at every contact; an island that fell apart sleeps late by this at most.
constexpr float kRebuildPart = 0.5f;

/// What a moving platform carries or pulls stays awake, however slow it is: it could be left in the air.
void keepCarriedAwake(World& world, std::vector<std::uint32_t>& verdict) {
    const auto moves = [&](std::uint32_t body) {
        const BodyInfo& info = world.bodies.info[body];
        return info.kind == BodyKind::Kinematic && (info.flags & kMoved) != 0;
    };
    const auto keepAwake = [&](std::uint32_t a, std::uint32_t b) {
        if (!moves(a) && !moves(b)) return;
        const std::uint32_t carried = moves(a) ? b : a;
        if (world.bodies.info[carried].kind == BodyKind::Dynamic) verdict[islandOf(world, carried)] = kNone;
    };
    for (const Contact& contact : world.contacts) {
        if ((contact.flags & kTouching) != 0) keepAwake(contact.bodyA, contact.bodyB);
    }
    for (const std::uint32_t j : world.joints.awake)
        keepAwake(world.joints.hot[j].bodyA, world.joints.hot[j].bodyB);
}

/// What comes out of an overlap that it was put into (initial_overlaps.hpp) is slow, but not at rest.
void keepOverlappingAwake(World& world, std::vector<std::uint32_t>& verdict) {
    for (const Contact& contact : world.contacts) {
        if ((contact.flags & kTouching) == 0 || (contact.flags & kInitialOverlap) == 0) continue;
        for (const std::uint32_t body : {contact.bodyA, contact.bodyB}) {
            if (world.bodies.info[body].kind == BodyKind::Dynamic) verdict[islandOf(world, body)] = kNone;
        }
    }
}

/// What slept while it is too deep in something would stay there.
void keepStrainedAwake(World& world, std::vector<std::uint32_t>& verdict) {
    if (world.bodies.substepControllers.empty()) return;
    for (const std::uint32_t body : world.awake) {
        if (world.bodies.info[body].kind == BodyKind::Dynamic &&
            isAtWork(world.bodies.substepControllers[body]))
            verdict[islandOf(world, body)] = kNone;
    }
}

}  // namespace

void putToSleep(StepContext& step) {
    World& world = step.world;
    if (world.islandsStale) world.islandsAge += step.dt;
    if (!step.work.sleepy) return;
    if (world.islandsAge >= kRebuildPart * world.settings.sleepTime) rebuildIslands(world);
    // An island sleeps when the most restless of its bodies has rested long enough.
    std::vector<std::uint32_t>& verdict = step.work.bodyScratch;  // by root
    verdict.assign(world.bodies.size(), kIslandToBe);
    for (const std::uint32_t body : world.awake) {
        if (world.bodies.info[body].kind != BodyKind::Dynamic) continue;
        if (world.bodies.motion[body].restTime < world.settings.sleepTime)
            verdict[islandOf(world, body)] = kNone;
    }
    if (world.manifest.runs(Effect::Kinematics)) keepCarriedAwake(world, verdict);
    keepOverlappingAwake(world, verdict);
    keepStrainedAwake(world, verdict);
    const bool some = std::any_of(world.awake.begin(), world.awake.end(), [&](std::uint32_t body) {
        return world.bodies.info[body].kind == BodyKind::Dynamic && verdict[islandOf(world, body)] != kNone;
    });
    if (some) sleepIslands(world, verdict);
}

}  // namespace plumb::physics
