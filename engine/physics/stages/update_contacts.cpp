#include <algorithm>

#include "physics/contacts/contacts.hpp"
#include "physics/islands/sleeping.hpp"
#include "physics/model/joints.hpp"
#include "physics/stages.hpp"

namespace plumb::physics {

namespace {

constexpr int kContactGrain = 256;
constexpr int kAtOnce = 128;  // contacts: these and their shapes fit into the L1 cache

bool touches(const Contact& contact) {
    if (contact.count == 0) return false;
    // Triggers touch if they overlap; solid shapes also at separations that the solver needs.
    return (contact.flags & kTriggered) == 0 || std::min(contact.separation0, contact.separation1) <= 0.0f;
}

/// Updates `count` contacts from `first` on. asked: checks again whether the filters allow each contact.
void lookAt(StepContext& step, std::size_t first, std::size_t count, bool asked, ContactFindings& found) {
    World& world = step.world;
    const std::span<Contact> contacts = std::span{world.contacts}.subspan(first, count);
    findTouches(world, contacts, step.dt, found.counts);
    std::uint16_t* keys = step.work.contactKeys.data() + first;
    Strips& strips = step.work.strips;  // strips of the last step
    for (std::size_t i = 0; i < count; ++i) {
        Contact& contact = contacts[i];
        if (strips.areUsed && contact.bodyB < strips.ofBody.size())
            strips.ofContact[first + i] = strips.ofBody[contact.bodyB];
        if (asked && (!mayCollide(world.shapes.filter[contact.shapeA], world.shapes.filter[contact.shapeB]) ||
                      keptApart(world, contact.bodyA, contact.bodyB)))
            contact.flags |= kGone;
        if ((contact.flags & (kFixedA | kTriggered | kPassing | kGone)) == kFixedA)
            found.fixed.push_back({contact.bodyB, static_cast<std::uint32_t>(first + i)});
        const bool before = (contact.flags & kTouching) != 0;
        if ((contact.flags & kGone) != 0 || touches(contact) != before) {
            found.changed.push_back(static_cast<std::uint32_t>(first + i));
        } else {
            keys[i] = keyOf(contact);
        }
    }
}

/// Updates every contact; results are in Workspace::contactFindings.
void lookAtAll(StepContext& step) {
    World& world = step.world;
    Workspace& work = step.work;
    work.contactKeys.resize(world.contacts.size());
    if (work.strips.areUsed) work.strips.ofContact.resize(world.contacts.size());
    const bool asked = std::exchange(world.filtersStale, false);
    forPieces(step.pool, world.contacts.size(), kContactGrain, work.contactFindings,
              [&](std::size_t begin, std::size_t end, ContactFindings& found) {
                  for (std::size_t first = begin; first < end; first += kAtOnce)
                      lookAt(step, first, std::min(end - first, std::size_t{kAtOnce}), asked, found);
              });
    work.counts = {};
    for (const ContactFindings& found : work.contactFindings) work.counts += found.counts;
}

std::uint32_t pushableA(const Contact& contact) {
    return (contact.flags & kFixedA) != 0 ? kNone : contact.bodyA;
}

void uncolour(Workspace& work, Contact& contact) {
    freeColour(work, pushableA(contact), contact.bodyB, contact.colour);
    contact.colour = kNoColour;
}

void end(World& world, Workspace& work, Contact& contact) {
    if ((contact.flags & kTouching) == 0) return;
    contact.flags &= static_cast<std::uint16_t>(~kTouching);
    uncolour(work, contact);
    world.islandsStale = true;
    report(world, work, contact, ContactPhase::Ended);
    if ((contact.flags & kTriggered) != 0) return;
    // Wakes sleeping bodies when a contact of theirs ends. May reallocate World::contacts.
    for (const std::uint32_t body : {contact.bodyA, contact.bodyB}) {
        if (world.sleepers.islandOf[body] != kNone) wake(world, body);
    }
}

/// Removes contacts with kGone. In reverse, so that the remaining indices stay valid.
void removeGone(World& world, Workspace& work) {
    for (std::size_t piece = work.contactFindings.size(); piece-- > 0;) {
        const std::vector<std::uint32_t>& changed = work.contactFindings[piece].changed;
        for (std::size_t i = changed.size(); i-- > 0;) {
            Contact& contact = world.contacts[changed[i]];
            if ((contact.flags & kGone) == 0) continue;
            work.pairs.remove(pairKey(contact.shapeA, contact.shapeB));
            contact = world.contacts.back();
            world.contacts.pop_back();
            work.contactKeys[changed[i]] = work.contactKeys.back();
            work.contactKeys.pop_back();
        }
    }
}

template <class Is>
void endContactsOf(StepContext& step, Is&& ends) {
    World& world = step.world;
    for (std::size_t i = world.contacts.size(); i-- > 0;) {
        Contact& contact = world.contacts[i];
        if (!ends(contact.shapeA) && !ends(contact.shapeB)) continue;
        if ((contact.flags & kTouching) != 0) {
            report(world, step.work, contact, ContactPhase::Ended);
            world.islandsStale = true;
        }
        uncolour(step.work, contact);
        step.work.pairs.remove(pairKey(contact.shapeA, contact.shapeB));
        contact = world.contacts.back();
        world.contacts.pop_back();
        step.work.layout.isCurrent = false;  // a contact of another group may now have its index and key
    }
}

void endContactsOfDead(StepContext& step) {
    World& world = step.world;
    endContactsOf(step, [&](std::uint32_t s) { return world.shapes.motion[s] == ProxyMotion::Gone; });
    const auto release = [](std::vector<std::uint32_t>& dying, std::vector<std::uint32_t>& free) {
        free.insert(free.end(), dying.rbegin(), dying.rend());
        dying.clear();
    };
    release(world.shapes.dying, world.shapes.free);
    release(world.bodies.dying, world.bodies.free);
    world.islandsStale = true;
}

}  // namespace

void endAltered(StepContext& step) {
    World& world = step.world;
    if (world.altered.empty()) return;
    std::vector<ShapeInfo>& info = world.shapes.info;
    // Wakes bodies that fell asleep with their contacts since the edit.
    for (const std::uint32_t shape : world.altered) wakeTouching(world, info[shape].body);
    endContactsOf(step, [&](std::uint32_t shape) { return (info[shape].flags & kAltered) != 0; });
    for (const std::uint32_t shape : world.altered) info[shape].flags &= static_cast<std::uint8_t>(~kAltered);
    world.altered.clear();
}

void beginContact(World& world, Workspace& work, std::size_t index) {
    Contact& begun = world.contacts[index];
    begun.flags |= kTouching | kBegan;
    if ((begun.flags & kInitialOverlap) != 0) addInitialOverlap(world, begun);
    if ((begun.flags & kReports) != 0)
        noteApproach(world, work, begun, world.bodies.motion[begun.bodyA], world.bodies.motion[begun.bodyB]);
    const std::uint32_t bodyA = pushableA(begun), bodyB = begun.bodyB;
    if ((begun.flags & kTriggered) == 0) {
        begun.colour = takeColour(work, bodyA, bodyB);
        for (const std::uint32_t body : {bodyA, bodyB})  // may reallocate World::contacts
            if (body != kNone && world.bodies.info[body].awakeIndex == kNone) wake(world, body);
    }
    if (bodyA != kNone) joinIslands(world, bodyA, bodyB);
}

void updateContacts(StepContext& step) {
    World& world = step.world;
    Workspace& work = step.work;
    if (!world.shapes.dying.empty() || !world.bodies.dying.empty()) endContactsOfDead(step);
    fadeInitialOverlaps(world, step.dt);
    work.approaches.clear();
    lookAtAll(step);
    correctSeams(step);
    for (const ContactFindings& found : work.contactFindings) {
        for (const std::uint32_t i : found.changed) {
            Contact& contact = world.contacts[i];
            const bool ends = (contact.flags & kGone) != 0 || !touches(contact);
            ends ? end(world, work, contact) : beginContact(world, work, i);
            work.contactKeys[i] = keyOf(world.contacts[i]);
        }
    }
    for (const std::uint32_t i : work.endedAtSeams) {
        end(world, work, world.contacts[i]);
        work.contactKeys[i] = keyOf(world.contacts[i]);
    }
    addKeys(world, work);
    removeGone(world, work);
}

}  // namespace plumb::physics
