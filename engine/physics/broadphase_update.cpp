#include "physics/broadphase_update.hpp"

#include <algorithm>

namespace plumb::physics {

namespace {

/// Fills what follows from the world, after it was written over or made.
void refill(World& world, Workspace& work) {
    work.pairs.clear();
    work.colourMasks.assign(world.bodies.size(), 0);
    const auto note = [&](const Contact& contact) {
        work.pairs.add(pairKey(contact.shapeA, contact.shapeB));
        if (contact.colour >= kColours) return;
        if (world.bodies.info[contact.bodyA].kind == BodyKind::Dynamic) {
            work.colourMasks[contact.bodyA] |= 1u << contact.colour;
        }
        work.colourMasks[contact.bodyB] |= 1u << contact.colour;
    };
    for (const Contact& contact : world.contacts) note(contact);
    for (const SleepingIsland& island : world.sleepers.islands) {
        for (std::uint32_t c = island.firstContact; c != kNone; c = world.sleepers.nextContact[c]) {
            note(world.sleepers.contacts[c]);
        }
    }
    for (const Joint& joint : world.joints.hot) {
        if (joint.bodyA == kNone || joint.colour >= kColours) continue;
        for (const std::uint32_t body : {joint.bodyA, joint.bodyB}) {
            if (world.bodies.info[body].kind == BodyKind::Dynamic)
                work.colourMasks[body] |= 1u << joint.colour;
        }
    }
}

}  // namespace

Proxies proxiesOf(const World& world) {
    return {world.shapes.bounds, world.shapes.filter, world.shapes.motion};
}

void updateBroadPhase(World& world, Workspace& work) {
    const bool stale = world.work.takeStale();
    work.isChanged.resize(world.shapes.size());
    work.isMoved.resize(world.shapes.size());
    work.colourMasks.resize(world.bodies.size());
    if (stale) refill(world, work);
    if (stale || work.broadPhaseKind != world.settings.broadPhase) {
        work.broadPhaseKind = world.settings.broadPhase;
        work.broadPhase = makeBroadPhase(work.broadPhaseKind);
        work.broadPhase->rebuild(proxiesOf(world));
        std::fill(work.isChanged.begin(), work.isChanged.end(), std::uint8_t{0});
    } else if (!work.changedProxies.empty()) {
        work.broadPhase->update(proxiesOf(world), work.changedProxies);
        for (const std::uint32_t shape : work.changedProxies) work.isChanged[shape] = 0;
    }
    work.changedProxies.clear();
}

}  // namespace plumb::physics
