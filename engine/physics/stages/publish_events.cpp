#include "physics/contacts.hpp"
#include "physics/stages.hpp"

namespace plumb::physics {

void publishEvents(StepContext& step) {
    World& world = step.world;
    const bool reports = world.manifest.runs(Effect::ContactEvents);
    for (const Contact& contact : world.contacts) {
        if ((contact.flags & kTouching) == 0) continue;
        if ((contact.flags & kBegan) == 0 && !world.settings.stayEvents) continue;
        if ((contact.flags & kTriggered) == 0 && ((contact.flags & kReports) == 0 || !reports)) continue;
        const ContactPhase phase = (contact.flags & kBegan) != 0 ? ContactPhase::Began : ContactPhase::Stayed;
        world.events.push_back(eventOf(world, contact, phase));
    }
}

}  // namespace plumb::physics
