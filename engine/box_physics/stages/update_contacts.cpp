#include <algorithm>
#include <cmath>

#include "box_physics/narrowphase/collide.hpp"
#include "box_physics/stages.hpp"

namespace plumb::box_physics {

namespace {

bool movable(const Bodies& b, std::uint32_t i) { return b.kind[i] == BodyKind::Dynamic; }

/// The one of a pair that is swept against the other: tile fields and one-way platforms are what is hit.
bool isHit(const Bodies& b, std::uint32_t i) {
    return b.shape[i].kind == ShapeKind::Tiles || (b.flags[i] & kOneWay) != 0;
}

float mixedFriction(float a, float b) {
    if (a < 0.0f) return std::max(b, 0.0f);
    if (b < 0.0f) return a;
    return std::sqrt(a * b);
}

/// Seconds until a gap closes at this speed; contacts that already touch take no time.
float closingTime(float separation, float closingSpeed, float dt) {
    if (separation <= 0.0f) return 0.0f;
    return closingSpeed * dt <= separation ? dt : separation / closingSpeed;
}

void fillContact(const StepContext& step, Contact& contact) {
    const Bodies& b = step.world.bodies;
    const std::uint32_t i = contact.a;
    const std::uint32_t j = contact.b;
    contact.friction = mixedFriction(b.friction[i], b.friction[j]);
    contact.mass = 1.0f / (b.inverseMass[i] + b.inverseMass[j]);
    const float speed = dot(contact.normal, b.velocity[i] - b.velocity[j]);
    contact.time = closingTime(contact.separation, -speed, step.dt);
    // The speed at the moment of the hit, not at the end of the step: so a bounce keeps its energy.
    const Workspace& work = step.world.work;
    const float pull = dot(contact.normal, work.pull[i] - work.pull[j]);
    const float later = pull * (step.dt - contact.time);
    const float bounciness = std::max(b.bounciness[i], b.bounciness[j]);
    const float hitSpeed = speed - later;
    if (bounciness > 0.0f && -hitSpeed > step.settings.bounceSpeed + std::abs(pull) * step.dt) {
        contact.targetSpeed = std::max(-bounciness * hitSpeed + later, 0.0f);
    }
}

void addContacts(StepContext& step, const Pair& pair) {
    World& world = step.world;
    const Bodies& b = world.bodies;
    const bool trigger = ((b.flags[pair.a] | b.flags[pair.b]) & kTrigger) != 0;
    const bool swapped = isHit(b, pair.a);
    const std::uint32_t moving = swapped ? pair.b : pair.a;
    const std::uint32_t other = swapped ? pair.a : pair.b;
    if (b.shape[moving].kind == ShapeKind::Tiles) return;
    Mover mover = moverOf(world, moving, world.work.path[moving] - world.work.path[other]);
    mover.slack = length(world.work.pull[moving] - world.work.pull[other]) * step.dt * step.dt;
    TouchList touches;
    collide(world, mover, other, step.settings, step.up, touches);
    if (trigger) touches.count = std::min(touches.count, 1);
    for (int i = 0; i < touches.count; ++i) {
        const Touch& touch = touches.items[i];
        Contact contact;
        contact.a = pair.a;
        contact.b = pair.b;
        contact.normal = swapped ? -touch.normal : touch.normal;
        contact.point = touchPoint(mover, touch);
        contact.separation = touch.separation;
        contact.isTrigger = trigger;
        if (!trigger) fillContact(step, contact);
        world.work.contacts.push_back(contact);
    }
}

/// What lies behind the first fixed thing in a body's way is not hit in this step; the body will be swept
/// again once the solver knows where it really goes.
void skipHidden(StepContext& step) {
    Workspace& work = step.world.work;
    const Bodies& b = step.world.bodies;
    work.earliest.assign(b.size(), step.dt);
    const auto bodyOf = [&b](const Contact& c) { return movable(b, c.a) ? c.a : c.b; };
    const auto isFixed = [&b](const Contact& c) { return !movable(b, c.a) || !movable(b, c.b); };
    for (const Contact& c : work.contacts) {
        if (c.isTrigger || !isFixed(c) || c.time <= 0.0f) continue;
        float& earliest = work.earliest[bodyOf(c)];
        earliest = std::min(earliest, c.time);
    }
    for (Contact& c : work.contacts) {
        if (c.isTrigger) continue;
        if (isFixed(c) && c.time > work.earliest[bodyOf(c)] * 1.001f) {
            c.skipped = true;
            work.marks[bodyOf(c)] |= kNeedsSweep;
            continue;
        }
        work.marks[c.a] |= kInContact;
        work.marks[c.b] |= kInContact;
    }
}

/// Contacts against fixed bodies are solved last: what must give way is never the ground.
void orderContacts(Workspace& work, const Bodies& b) {
    work.order.clear();
    for (const bool fixed : {false, true}) {
        for (std::uint32_t i = 0; i < work.contacts.size(); ++i) {
            const Contact& c = work.contacts[i];
            const bool isFixed = !movable(b, c.a) || !movable(b, c.b);
            if (!c.isTrigger && !c.skipped && isFixed == fixed) work.order.push_back(i);
        }
    }
}

}  // namespace

void updateContacts(StepContext& step) {
    Workspace& work = step.world.work;
    work.contacts.clear();
    for (const Pair& pair : work.pairs) addContacts(step, pair);
    skipHidden(step);
    orderContacts(work, step.world.bodies);
}

}  // namespace plumb::box_physics
