#include <algorithm>

#include "physics/sleeping.hpp"
#include "physics/stages.hpp"

namespace plumb::physics {

namespace {

/// Ties that ended keep islands larger than need be; to look for them each step is not worth it.
constexpr std::uint64_t kStepsBetweenRebuilds = 16;

}  // namespace

void putToSleep(StepContext& step) {
    World& world = step.world;
    if (!step.work.sleepy || !world.settings.sleeping) return;
    if (world.islandsStale && world.steps % kStepsBetweenRebuilds == 0) rebuildIslands(world);
    // An island sleeps when the most restless of its bodies has rested long enough.
    std::vector<std::uint32_t>& verdict = step.work.bodyScratch;  // by root
    verdict.assign(world.bodies.size(), kIslandToBe);
    for (const std::uint32_t body : world.awake) {
        if (world.bodies.info[body].kind != BodyKind::Dynamic) continue;
        if (world.bodies.motion[body].restTime < world.settings.sleepTime)
            verdict[islandOf(world, body)] = kNone;
    }
    const bool some = std::any_of(world.awake.begin(), world.awake.end(), [&](std::uint32_t body) {
        return world.bodies.info[body].kind == BodyKind::Dynamic && verdict[islandOf(world, body)] != kNone;
    });
    if (some) sleepIslands(world, verdict);
}

}  // namespace plumb::physics
