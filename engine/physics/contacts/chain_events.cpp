#include <algorithm>
#include <iterator>

#include "physics/contacts/contacts.hpp"
#include "physics/workspace.hpp"

namespace plumb::physics {

namespace {

constexpr std::uint32_t kIsSurface = 1u << 31;

std::uint32_t sideOf(const World& world, std::uint32_t shape) {
    const std::uint32_t surface = world.shapes.info[shape].surface;
    return surface != 0 ? surface | kIsSurface : shape;
}

bool isOfSurface(const World& world, const Contact& contact) {
    return (world.shapes.info[contact.shapeA].surface | world.shapes.info[contact.shapeB].surface) != 0;
}

PairKey keyOf(const World& world, const Contact& contact) {
    return pairKey(sideOf(world, contact.shapeA), sideOf(world, contact.shapeB));
}

/// Combined result of all changes of a pair in a step.
struct Outcome {
    std::int32_t count = 0;  // number of contacts after the step
    const ContactEvent* first = nullptr;
    const ContactEvent* last = nullptr;
    float impulse = 0.0f;  // N s
};

void publish(World& world, std::int32_t before, const Outcome& now) {
    const auto add = [&](const ContactEvent& event, ContactPhase phase) {
        world.events.push_back(event);
        world.events.back().phase = phase;
        world.events.back().impulse = now.impulse;
    };
    if (before == 0 && now.count > 0) return add(*now.first, ContactPhase::Began);
    if (before > 0 && now.count == 0) return add(*now.last, ContactPhase::Ended);
    if (before > 0 && world.settings.stayEvents && now.first->phase != ContactPhase::Ended)
        add(*now.first, ContactPhase::Stayed);
}

/// Returns the maximum approach speed (m/s) of a pair, which may have begun to touch several times.
float approachOf(const Workspace& work, const Contact& contact) {
    const PairKey pair = pairKey(contact.shapeA, contact.shapeB);
    const auto after = std::upper_bound(work.approaches.begin(), work.approaches.end(),
                                        std::pair{pair, std::numeric_limits<float>::infinity()});
    const bool known = after != work.approaches.begin() && std::prev(after)->first == pair;
    return known ? std::prev(after)->second : 0.0f;
}

bool isReported(const World& world, const Contact& contact) {
    if ((contact.flags & kPassing) != 0) return false;
    return (contact.flags & kTriggered) != 0 ||
           ((contact.flags & kReports) != 0 &&
            (world.manifest.pinnedOff & Manifest::bit(Effect::ContactEvents)) == 0);
}

}  // namespace

void report(World& world, Workspace& work, const Contact& contact, ContactPhase phase, float impulse) {
    if (!isReported(world, contact)) return;
    const BodyPose& a = world.bodies.pose[contact.bodyA];
    const ContactEvent event{
        .a = idOfBody(world, contact.bodyA),
        .b = idOfBody(world, contact.bodyB),
        .shapeA = idOfShape(world, contact.shapeA),
        .shapeB = idOfShape(world, contact.shapeB),
        .phase = phase,
        .isTrigger = (contact.flags & kTriggered) != 0,
        .normal = contact.normal,
        .point = toVec2(a.centre + rotate(a.rotation, pointOf(world, contact, 0))),
        .impulse = impulse,
        .approachSpeed = phase == ContactPhase::Began ? approachOf(work, contact) : 0.0f};
    if (!isOfSurface(world, contact)) return world.events.push_back(event);
    const auto order = static_cast<std::uint32_t>(work.chainChanges.size());
    work.chainChanges.push_back({keyOf(world, contact), order, event});
}

void noteApproach(const World& world, Workspace& work, const Contact& contact, const BodyMotion& a,
                  const BodyMotion& b) {
    float fastest = 0.0f;
    for (int i = 0; i < contact.count; ++i) {
        const Vec2 armA = rotate(world.bodies.pose[contact.bodyA].rotation, contact.anchors[i].a);
        const Vec2 armB = rotate(world.bodies.pose[contact.bodyB].rotation, contact.anchors[i].b);
        const Vec2 speed =
            b.velocity + cross(b.angularVelocity, armB) - a.velocity - cross(a.angularVelocity, armA);
        fastest = std::max(fastest, -dot(contact.normal, speed));
    }
    work.approaches.emplace_back(pairKey(contact.shapeA, contact.shapeB), fastest);
}

void publishSurfaces(World& world, Workspace& work) {
    std::vector<ChainChange>& changes = work.chainChanges;
    if (changes.empty()) return;
    // New and continuing contacts first, so that an event refers to a contact that exists.
    const auto rank = [](const ChainChange& change) { return change.event.phase == ContactPhase::Ended; };
    std::sort(changes.begin(), changes.end(), [&](const ChainChange& a, const ChainChange& b) {
        if (a.pair != b.pair) return a.pair < b.pair;
        return rank(a) != rank(b) ? rank(b) : a.order < b.order;
    });
    std::vector<ChainTouch>& merged = work.chainScratch;
    merged.clear();
    auto known = work.chainTouches.begin();
    for (auto change = changes.begin(); change != changes.end();) {
        const PairKey pair = change->pair;
        while (known != work.chainTouches.end() && known->pair < pair) merged.push_back(*known++);
        const bool isKnown = known != work.chainTouches.end() && known->pair == pair;
        const std::int32_t before = isKnown ? (known++)->count : 0;
        Outcome now{before, &change->event, &change->event};
        for (; change != changes.end() && change->pair == pair; ++change) {
            const ContactPhase phase = change->event.phase;
            now.count += phase == ContactPhase::Began ? 1 : (phase == ContactPhase::Ended ? -1 : 0);
            now.last = &change->event;
            now.impulse += change->event.impulse;
        }
        now.count = std::max(now.count, 0);
        publish(world, before, now);
        if (now.count > 0) merged.push_back({pair, now.count});
    }
    merged.insert(merged.end(), known, work.chainTouches.end());
    work.chainTouches.swap(merged);
    changes.clear();
}

void countSurfaces(const World& world, Workspace& work) {
    std::vector<PairKey> pairs;
    forContacts(world, [&](const Contact& contact) {
        const bool counts = (contact.flags & kTouching) != 0 && isReported(world, contact);
        if (counts && isOfSurface(world, contact)) pairs.push_back(keyOf(world, contact));
    });
    std::sort(pairs.begin(), pairs.end());
    work.chainTouches.clear();
    work.chainChanges.clear();
    for (const PairKey pair : pairs) {
        const bool again = !work.chainTouches.empty() && work.chainTouches.back().pair == pair;
        if (!again) work.chainTouches.push_back({pair, 0});
        ++work.chainTouches.back().count;
    }
}

}  // namespace plumb::physics
