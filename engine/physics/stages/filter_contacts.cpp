#include <algorithm>

#include "physics/contacts/contacts.hpp"
#include "physics/effects/one_way.hpp"
#include "physics/ranges.hpp"
#include "physics/stages.hpp"

namespace plumb::physics {

namespace {

/// Whether it lets through is decided when a contact begins, and kept: what is half through must not be
/// caught.
void decideOneWay(StepContext& step, Contact& contact) {
    World& world = step.world;
    if ((contact.flags & (kOneWayA | kOneWayB)) == 0) return;
    if ((contact.flags & kBegan) != 0) {
        contact.flags &= static_cast<std::uint16_t>(~kPassing);
        if (passesThrough(world, contact, step.dt)) contact.flags |= kPassing;
    } else if ((contact.flags & kPassing) == 0 && dropsThrough(world, contact)) {
        report(world, step.work, contact, ContactPhase::Ended);
        contact.flags |= kPassing;
    }
    if ((contact.flags & kPassing) != 0) contact.flags |= kDisabled;
}

void askOwner(StepContext& step, Contact& contact) {
    const ContactHooks& hooks = step.hooks;
    if (hooks.preSolve == nullptr || (contact.flags & kDisabled) != 0) return;
    if (!ask(step.world, [&] { return hooks.preSolve(hooks.context, step.world, contact); }))
        contact.flags |= kDisabled;
}

}  // namespace

void askForMaterial(const StepContext& step, Contact& contact) {
    const auto answer = [&](auto* callback, float known, float maximum) {
        if (callback == nullptr) return known;
        const float wanted =
            ask(step.world, [&] { return callback(step.hooks.context, step.world, contact); });
        return wanted > 0.0f ? std::min(wanted, maximum) : 0.0f;
    };
    contact.friction = answer(step.hooks.friction, contact.friction, kRoughest);
    contact.bounciness = answer(step.hooks.bounciness, contact.bounciness, 1.0f);
}

void filterContacts(StepContext& step) {
    std::vector<Contact>& contacts = step.world.contacts;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        Contact& contact = contacts[i];
        if ((contact.flags & (kTouching | kTriggered)) != kTouching) continue;
        decideOneWay(step, contact);
        askForMaterial(step, contact);
        askOwner(step, contact);
        if ((contact.flags & kDisabled) != 0) step.work.contactKeys[i] = keyOf(contact);
    }
}

}  // namespace plumb::physics
