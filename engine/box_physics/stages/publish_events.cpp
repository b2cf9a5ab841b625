#include <cmath>

#include "box_physics/stages.hpp"

namespace plumb::box_physics {

namespace {

bool before(const ContactEvent& x, const ContactEvent& y) {
    if (x.a.index != y.a.index) return x.a.index < y.a.index;
    if (x.b.index != y.b.index) return x.b.index < y.b.index;
    if (x.a.generation != y.a.generation) return x.a.generation < y.a.generation;
    return x.b.generation < y.b.generation;
}

/// The pairs that touch now, one each, in the order of the contacts, which is that of the bodies.
void gatherTouching(World& world) {
    const Bodies& b = world.bodies;
    std::vector<ContactEvent>& now = world.work.touching;
    now.clear();
    for (const Contact& c : world.work.contacts) {
        if (c.skipped) continue;
        const bool known = !now.empty() && now.back().a.index == c.a && now.back().b.index == c.b;
        if (!known) {
            ContactEvent event;
            event.isTrigger = c.isTrigger;
            event.a = {c.a, b.generation[c.a]};
            event.b = {c.b, b.generation[c.b]};
            event.userA = b.user[c.a];
            event.userB = b.user[c.b];
            event.impulse = -1.0f;
            now.push_back(event);
        }
        ContactEvent& event = now.back();
        if (c.normalImpulse <= event.impulse) continue;
        event.normal = -c.normal;
        event.point = c.point;
        event.impulse = c.normalImpulse;
    }
}

void publish(World& world, ContactEvent event, ContactPhase phase) {
    event.phase = phase;
    world.events.push_back(event);
}

}  // namespace

void publishEvents(StepContext& step) {
    World& world = step.world;
    gatherTouching(world);
    std::vector<ContactEvent>& now = world.work.touching;
    std::size_t old = 0;
    for (const ContactEvent& event : now) {
        while (old < world.touching.size() && before(world.touching[old], event)) {
            publish(world, world.touching[old++], ContactPhase::Ended);
        }
        const bool known = old < world.touching.size() && !before(event, world.touching[old]);
        const bool sameRole = known && world.touching[old].isTrigger == event.isTrigger;
        if (known && !sameRole) publish(world, world.touching[old], ContactPhase::Ended);
        publish(world, event, sameRole ? ContactPhase::Stayed : ContactPhase::Began);
        if (known) ++old;
    }
    while (old < world.touching.size()) publish(world, world.touching[old++], ContactPhase::Ended);
    world.touching.swap(now);
}

}  // namespace plumb::box_physics
