#include <algorithm>

#include "physics/bounds.hpp"
#include "physics/contacts/contacts.hpp"
#include "physics/islands/sleeping.hpp"
#include "physics/model/joints.hpp"
#include "physics/stages.hpp"

namespace plumb::physics {

namespace {

constexpr int kPairGrain = 128;

void search(StepContext& step) {
    World& world = step.world;
    Workspace& work = step.work;
    for (const std::uint32_t shape : world.moved) work.isMoved[shape] = 1;
    work.broadPhase->arrange(world.moved);
    const std::span<const std::uint32_t> moved{world.moved};
    collect(step, moved.size(), kPairGrain, work.foundPairs, work.newPairs,
            [&](std::size_t begin, std::size_t end, std::vector<PairKey>& found) {
                work.broadPhase->findPairs(moved.subspan(begin, end - begin), work.isMoved, found);
                std::erase_if(found, [&](PairKey key) { return work.pairs.has(key); });
            });
    // Sorted, so that the order of contacts does not depend on threads.
    std::sort(work.newPairs.begin(), work.newPairs.end());
    for (const std::uint32_t shape : world.moved) {
        work.isMoved[shape] = 0;
        world.shapes.info[shape].flags &= static_cast<std::uint8_t>(~kLeftBounds);
    }
    world.moved.clear();
}

void makeContacts(StepContext& step) {
    World& world = step.world;
    for (const PairKey key : step.work.newPairs) {
        const auto a = static_cast<std::uint32_t>(key >> 32), b = static_cast<std::uint32_t>(key);
        const std::uint32_t bodyA = world.shapes.info[a].body, bodyB = world.shapes.info[b].body;
        const bool joined =
            world.bodies.info[bodyA].firstJoint != kNone && world.bodies.info[bodyB].firstJoint != kNone;
        if (joined && keptApart(world, bodyA, bodyB)) continue;
        if (!needsContact(world, a, b) || !mayMeet(step, a, b)) continue;
        const auto isAwake = [&](std::uint32_t body) { return world.bodies.info[body].awakeIndex != kNone; };
        // A resting trigger overlaps a sleeping body: wakes it, because only awake contacts are updated.
        if (!isAwake(bodyA) && !isAwake(bodyB)) wake(world, isDynamic(world, bodyA) ? bodyA : bodyB);
        step.work.pairs.add(key);
        world.contacts.push_back(makeContact(world, a, b));
    }
}

/// Wakes bodies on the path of a fast kinematic body, as an overlap would be found too late.
void wakeOnPaths(World& world, Workspace& work, float dt) {
    if (world.sleepers.islands.size() == world.sleepers.freeIslands.size()) return;
    std::vector<std::uint32_t>& found = work.candidates;
    const std::size_t awake = world.awake.size();
    for (std::size_t i = 0; i < awake; ++i) {
        const std::uint32_t body = world.awake[i];
        const BodyInfo& info = world.bodies.info[body];
        if (info.kind != BodyKind::Kinematic) continue;
        const BodyMotion& motion = world.bodies.motion[body];
        const Vec2 displacement = dt * motion.velocity;
        if (!isFast(displacement, dt * motion.angularVelocity, info)) continue;
        found.clear();
        work.broadPhase->cast(toVec2(world.bodies.pose[body].centre), displacement, {info.reach, info.reach},
                              0xffffffffu, found, Among::All);
        std::erase_if(found,
                      [&](std::uint32_t shape) { return world.shapes.motion[shape] != ProxyMotion::Asleep; });
        // The order of the broad phase's results is arbitrary.
        std::sort(found.begin(), found.end());
        for (const std::uint32_t shape : found) wake(world, world.shapes.info[shape].body);
    }
}

}  // namespace

void findPairs(StepContext& step) {
    updateBroadPhase(step.world, step.work);
    if (!step.world.altered.empty()) {
        endAltered(step);
        updateBroadPhase(step.world, step.work);  // for bodies woken by endAltered()
    }
    if (step.runs(Effect::Kinematics)) {  // maximum size, so that later steps allocate nothing
        step.work.candidates.reserve(step.world.shapes.info.capacity());
        step.work.passedBodies.reserve(step.world.bodies.info.capacity());
        step.work.fastBodies.reserve(step.world.bodies.info.capacity());
    }
    if (step.runs(Effect::Kinematics) && step.runs(Effect::Sleep)) {
        wakeOnPaths(step.world, step.work, step.dt);
        updateBroadPhase(step.world, step.work);
    }
    Shapes& shapes = step.world.shapes;
    std::erase_if(step.world.moved, [&](std::uint32_t s) {
        if (shapes.motion[s] != ProxyMotion::Gone) return false;
        shapes.info[s].flags &= static_cast<std::uint8_t>(~kLeftBounds);
        return true;
    });
    if (step.world.moved.empty()) return;
    search(step);
    makeContacts(step);
}

}  // namespace plumb::physics
