#include <algorithm>

#include "physics/contacts/contacts.hpp"
#include "physics/tuning.hpp"

namespace plumb::physics {

namespace {

/// Returns an upper bound (m) of the depth that a new contact can reach by the motion of a step.
float depthByMotion(const World& world, const Contact& contact) {
    const BodyMotion& a = world.bodies.motion[contact.bodyA];
    const BodyMotion& b = world.bodies.motion[contact.bodyB];
    const float turning = std::fabs(a.angularVelocity) * world.bodies.info[contact.bodyA].reach +
                          std::fabs(b.angularVelocity) * world.bodies.info[contact.bodyB].reach;
    return world.settings.slop + 2.0f * world.stepLength * (length(b.velocity - a.velocity) + turning);
}

float depthOf(const Contact& contact) { return -std::min(contact.separation0, contact.separation1); }

/// Returns the entry of the pair in the sorted list, or the position to insert it.
template <class Overlaps>
auto findPair(Overlaps& overlaps, PairKey pair) {
    return std::lower_bound(overlaps.begin(), overlaps.end(), pair,
                            [](const InitialOverlap& overlap, PairKey key) { return overlap.pair < key; });
}

void hide(Contact& contact, float hidden) {
    if (contact.separation0 < 0.0f) contact.separation0 = std::min(contact.separation0 + hidden, 0.0f);
    if (contact.separation1 < 0.0f) contact.separation1 = std::min(contact.separation1 + hidden, 0.0f);
}

}  // namespace

void markInitialOverlap(const World& world, Contact& contact) {
    contact.flags &= static_cast<std::uint16_t>(~kInitialOverlap);
    // Excludes contacts without forces: one-way shapes (a body inside falls through) and triggers.
    if ((contact.flags & (kOneWayA | kOneWayB | kTriggered)) != 0) return;
    const float depth = depthOf(contact);
    if (depth > 2.0f * world.settings.slop && depth > depthByMotion(world, contact))
        contact.flags |= kInitialOverlap;
}

void addInitialOverlap(World& world, Contact& contact) {
    const PairKey pair = pairKey(contact.shapeA, contact.shapeB);
    auto place = findPair(world.initialOverlaps, pair);
    if (place == world.initialOverlaps.end() || place->pair != pair)
        place = world.initialOverlaps.insert(place, {pair, 0.0f});
    place->hidden = depthOf(contact);
    hide(contact, place->hidden);
}

void fadeInitialOverlaps(World& world, float dt) {
    if (world.initialOverlaps.empty()) return;
    const float shown = kFadeRate * std::sqrt(world.settings.slop) * dt;
    for (InitialOverlap& overlap : world.initialOverlaps) {
        const float root = std::max(std::sqrt(overlap.hidden) - shown, 0.0f);
        overlap.hidden = root * root;
    }
    std::erase_if(world.initialOverlaps, [](const InitialOverlap& old) { return old.hidden == 0.0f; });
}

void hideInitialOverlap(const World& world, Contact& contact) {
    const PairKey pair = pairKey(contact.shapeA, contact.shapeB);
    const auto place = findPair(world.initialOverlaps, pair);
    if (place != world.initialOverlaps.end() && place->pair == pair) return hide(contact, place->hidden);
    contact.flags &= static_cast<std::uint16_t>(~kInitialOverlap);
}

}  // namespace plumb::physics
