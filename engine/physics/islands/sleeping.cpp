#include "physics/islands/sleeping.hpp"

#include "physics/bounds.hpp"
#include "physics/edits.hpp"
#include "physics/stages.hpp"

namespace plumb::physics {

namespace {

constexpr int kIslandGrain = 512;

// The free lists have capacity for all entries, so that waking an island allocates nothing.

std::uint32_t takeIsland(Sleepers& sleepers) {
    const std::uint32_t island = takeIndex(sleepers.freeIslands, sleepers.islands);
    sleepers.freeIslands.reserve(sleepers.islands.capacity());
    sleepers.islands[island] = {};
    return island;
}

void putInIsland(World& world, std::uint32_t island, std::uint32_t body) {
    Sleepers& sleepers = world.sleepers;
    sleepers.islandOf[body] = island;
    sleepers.nextBody[body] = std::exchange(sleepers.islands[island].firstBody, body);
    BodyMotion& motion = world.bodies.motion[body];
    motion.velocity = {};
    motion.angularVelocity = 0.0f;
    forShapesOf(world, body, [&](std::uint32_t s) {
        world.shapes.motion[s] = ProxyMotion::Asleep;
        noteChanged(world, s);
    });
}

void putInIsland(Sleepers& sleepers, std::uint32_t island, const Contact& contact) {
    const std::uint32_t place = takeIndex(sleepers.freeContacts, sleepers.contacts, sleepers.nextContact);
    sleepers.freeContacts.reserve(sleepers.contacts.capacity());
    sleepers.contacts[place] = contact;
    sleepers.nextContact[place] = std::exchange(sleepers.islands[island].firstContact, place);
}

/// True for contacts that are not stored with a sleeping island. A kinematic body can begin or end a contact
/// while the other body sleeps, except if that body rests on it: then it wakes the body when it starts to
/// move (wakeForMotion). Contacts of destroyed shapes stay too: the next step ends them.
bool staysInStep(const World& world, const Contact& contact) {
    for (const std::uint32_t shape : {contact.shapeA, contact.shapeB}) {
        if (world.shapes.motion[shape] == ProxyMotion::Gone) return true;
    }
    if ((contact.flags & (kTouching | kTriggered)) == kTouching) return false;
    return world.bodies.info[contact.bodyA].kind == BodyKind::Kinematic ||
           world.bodies.info[contact.bodyB].kind == BodyKind::Kinematic;
}

/// Moves touching contacts to their sleeping islands; removes others, which are found again later.
void takeContactsAlong(World& world) {
    std::vector<Contact>& contacts = world.contacts;
    for (std::size_t i = contacts.size(); i-- > 0;) {
        Contact& contact = contacts[i];
        if (isUp(world, contact.bodyA) || isUp(world, contact.bodyB)) continue;
        if (staysInStep(world, contact)) continue;
        const std::uint32_t islandB = world.sleepers.islandOf[contact.bodyB];
        const std::uint32_t island = islandB != kNone ? islandB : world.sleepers.islandOf[contact.bodyA];
        if (island == kNone) continue;
        if ((contact.flags & kTouching) != 0) {
            contact.flags &= static_cast<std::uint16_t>(~kBegan);  // no second Began event after waking
            putInIsland(world.sleepers, island, contact);
        } else if (!world.work.stale()) {
            world.work.get().pairs.remove(pairKey(contact.shapeA, contact.shapeB));
        }
        contacts[i] = contacts.back();
        contacts.pop_back();
    }
}

void wakeIsland(World& world, std::uint32_t island) {
    Sleepers& sleepers = world.sleepers;
    for (std::uint32_t body = sleepers.islands[island].firstBody; body != kNone;) {
        const std::uint32_t next = std::exchange(sleepers.nextBody[body], kNone);
        sleepers.islandOf[body] = kNone;
        addAwake(world, body);
        world.bodies.motion[body].restTime = 0.0f;
        forShapesOf(world, body, [&](std::uint32_t s) {
            world.shapes.motion[s] = ProxyMotion::Awake;
            noteChanged(world, s);
            noteMoved(world, s);
        });
        forJointsOf(world, body, [&](std::uint32_t j) { addAwakeJoint(world, j); });
        body = next;
    }
    for (std::uint32_t c = sleepers.islands[island].firstContact; c != kNone;) {
        world.contacts.push_back(sleepers.contacts[c]);
        sleepers.freeContacts.push_back(c);
        c = std::exchange(sleepers.nextContact[c], kNone);
    }
    sleepers.islands[island] = {};
    sleepers.freeIslands.push_back(island);
}

/// Removes object `index` from a list. @param members  all objects; `awakeIndex` is their index in the list
template <class Member>
void takeOut(std::vector<std::uint32_t>& list, std::vector<Member>& members, std::uint32_t index) {
    const std::uint32_t awakeIndex = members[index].awakeIndex;
    if (awakeIndex == kNone) return;
    list[awakeIndex] = list.back();
    members[list[awakeIndex]].awakeIndex = awakeIndex;
    members[index].awakeIndex = kNone;  // last, because the member may be the moved one itself
    list.pop_back();
}

}  // namespace

void addAwake(World& world, std::uint32_t body) {
    world.bodies.info[body].awakeIndex = static_cast<std::uint32_t>(world.awake.size());
    world.awake.push_back(body);
}

void addAsleep(World& world, std::uint32_t body) { putInIsland(world, takeIsland(world.sleepers), body); }

void removeAwake(World& world, std::uint32_t body) { takeOut(world.awake, world.bodies.info, body); }

void removeAwakeJoint(World& world, std::uint32_t joint) {
    world.work.get().joints.trees.stale = true;
    takeOut(world.joints.awake, world.joints.hot, joint);
}

void addAwakeJoint(World& world, std::uint32_t index) {
    Joint& joint = world.joints.hot[index];
    const auto isOff = [&](std::uint32_t body) { return (world.bodies.info[body].owned & kBodyOff) != 0; };
    if (joint.awakeIndex != kNone || joint.kind == JointKind::Filter || isOff(joint.bodyA) ||
        isOff(joint.bodyB))
        return;
    world.work.get().joints.trees.stale = true;
    joint.awakeIndex = static_cast<std::uint32_t>(world.joints.awake.size());
    world.joints.awake.push_back(index);
}

void wake(World& world, std::uint32_t body) {
    const std::uint32_t island = world.sleepers.islandOf[body];
    if (island != kNone) wakeIsland(world, island);
    world.bodies.motion[body].restTime = 0.0f;
}

void wakeAll(World& world) {
    for (std::uint32_t island = 0; island < world.sleepers.islands.size(); ++island) {
        const std::uint32_t body = world.sleepers.islands[island].firstBody;
        if (body != kNone) wake(world, body);
    }
}

void wakeTouching(World& world, std::uint32_t body) {
    wake(world, body);
    if (isDynamic(world, body)) return;
    forJointsOf(world, body, [&](std::uint32_t j) {
        const Joint& joint = world.joints.hot[j];
        wake(world, joint.bodyA == body ? joint.bodyB : joint.bodyA);
    });
    std::vector<std::uint32_t> touched;
    for (const SleepingIsland& island : world.sleepers.islands) {
        for (std::uint32_t c = island.firstContact; c != kNone; c = world.sleepers.nextContact[c]) {
            const Contact& contact = world.sleepers.contacts[c];
            if (contact.bodyA == body || contact.bodyB == body) {
                touched.push_back(island.firstBody);
                break;
            }
        }
    }
    for (const std::uint32_t other : touched) wake(world, other);
}

void wakeForMotion(World& world, std::uint32_t body) {
    const BodyMotion& motion = world.bodies.motion[body];
    const bool moved = (world.bodies.info[body].flags & kMoved) != 0;
    const bool starts = !moved && motion.velocity == Vec2{} && motion.angularVelocity == 0.0f;
    starts ? wakeTouching(world, body) : wake(world, body);
}

void sleepIslands(World& world, std::vector<std::uint32_t>& sleepingRoots) {
    // A single pass over bodies, contacts and joints for any number of islands. `sleepingRoots` is kNone for
    // a root that stays awake, otherwise kIslandToBe or the index of its sleeping island.
    std::vector<std::uint32_t>& awake = world.awake;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < awake.size(); ++i) {
        const std::uint32_t body = awake[i];
        BodyInfo& info = world.bodies.info[body];
        const std::uint32_t root = info.kind == BodyKind::Dynamic ? islandOf(world, body) : kNone;
        if (root == kNone || sleepingRoots[root] == kNone) {
            info.awakeIndex = static_cast<std::uint32_t>(kept);
            awake[kept++] = body;
            continue;
        }
        if (sleepingRoots[root] == kIslandToBe) sleepingRoots[root] = takeIsland(world.sleepers);
        info.awakeIndex = kNone;
        world.fellAsleep.push_back({body, info.generation});
        putInIsland(world, sleepingRoots[root], body);
        forJointsOf(world, body, [&](std::uint32_t j) { removeAwakeJoint(world, j); });
    }
    awake.resize(kept);
    takeContactsAlong(world);
}

void sleepNow(World& world, std::uint32_t body) {
    if (!isUp(world, body)) return;
    std::vector<std::uint32_t> roots(world.bodies.size(), kNone);
    rebuildIslands(world);
    const std::uint32_t root = islandOf(world, body);
    // An edit may have ended one of its contacts. Then it stays awake, and the next step ends the contact.
    const auto mayEnd = [&](const Contact& contact) {
        if ((contact.flags & kFixedA) == 0 || islandOf(world, contact.bodyB) != root) return false;
        return world.filtersStale || (world.shapes.info[contact.shapeA].flags & kLeftBounds) != 0;
    };
    if (std::any_of(world.contacts.begin(), world.contacts.end(), mayEnd)) return;
    roots[root] = kIslandToBe;
    sleepIslands(world, roots);
}

void rebuildIslands(World& world, TaskPool* pool) {
    std::vector<BodyInfo>& info = world.bodies.info;
    const auto forAll = [&](const auto& all, auto&& act) {
        forEach(pool, all.size(), kIslandGrain, [&](std::size_t i) { act(all[i]); });
    };
    const auto join = [&](std::uint32_t a, std::uint32_t b) {
        if (isUp(world, a) && isUp(world, b)) joinIslands(world, a, b);
    };
    forAll(world.awake, [&](std::uint32_t body) { info[body].island = body; });
    forAll(world.contacts, [&](const Contact& contact) {
        if ((contact.flags & kTouching) != 0) join(contact.bodyA, contact.bodyB);
    });
    forAll(world.joints.awake,
           [&](std::uint32_t j) { join(world.joints.hot[j].bodyA, world.joints.hot[j].bodyB); });
    // Replaces parents by roots, so that the result does not depend on the order of joins by threads.
    forAll(world.awake, [&](std::uint32_t body) {
        std::atomic_ref{info[body].island}.store(islandOf(world, body), std::memory_order_relaxed);
    });
    world.islandsStale = false;
    world.islandsAge = 0.0f;
}

}  // namespace plumb::physics
