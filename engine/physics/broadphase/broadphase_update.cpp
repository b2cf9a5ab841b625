#include "physics/broadphase/broadphase_update.hpp"

#include <algorithm>

#include "physics/contacts/contacts.hpp"
#include "physics/model/edits.hpp"

namespace plumb::physics {

namespace {

/// Recomputes what follows from a world that was created or overwritten.
void refill(World& world, Workspace& work) {
    work.pairs.clear();
    countSurfaces(world, work);
    forContacts(world,
                [&](const Contact& contact) { work.pairs.add(pairKey(contact.shapeA, contact.shapeB)); });
}

/// The shapes of a world as the broad phase reads them.
Proxies proxiesOf(const World& world) {
    return {world.shapes.bounds, world.shapes.filter, world.shapes.motion};
}

}  // namespace

void updateBroadPhase(World& world, Workspace& work) {
    refreshColours(world, work);  // before the flag is reset
    const bool stale = world.work.takeStale();
    work.isChanged.resize(world.shapes.size());
    work.isMoved.resize(world.shapes.size());
    if (stale) {
        refill(world, work);
        work.joints.trees.stale = true;
    }
    if (stale || work.broadPhaseKind != world.settings.broadPhase) {
        if (work.broadPhase == nullptr || work.broadPhaseKind != world.settings.broadPhase)
            work.broadPhase = makeBroadPhase(world.settings.broadPhase);
        work.broadPhaseKind = world.settings.broadPhase;
        work.broadPhase->rebuild(proxiesOf(world));
        std::fill(work.isChanged.begin(), work.isChanged.end(), std::uint8_t{0});
    } else if (!work.changedProxies.empty()) {
        work.broadPhase->update(proxiesOf(world), work.changedProxies);
        for (const std::uint32_t shape : work.changedProxies) work.isChanged[shape] = 0;
    }
    work.changedProxies.clear();
}

}  // namespace plumb::physics
