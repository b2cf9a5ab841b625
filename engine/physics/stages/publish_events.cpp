#include "physics/contacts.hpp"
#include "physics/stages.hpp"

namespace plumb::physics {

void publishEvents(StepContext& step) {
    World& world = step.world;
    for (std::size_t i = 0; i < world.contacts.size(); ++i) {
        const bool began = (step.work.contactKeys[i] & kKeyBegan) != 0;
        if (!began && !world.settings.stayEvents) continue;
        const Contact& contact = world.contacts[i];
        if ((contact.flags & kTouching) == 0) continue;
        if (!isReported(world, contact)) continue;
        world.events.push_back(eventOf(world, contact, began ? ContactPhase::Began : ContactPhase::Stayed));
    }
}

}  // namespace plumb::physics
