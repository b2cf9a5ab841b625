#include "physics/stages.hpp"
#include "physics/surfaces.hpp"

namespace plumb::physics {

void publishEvents(StepContext& step) {
    World& world = step.world;
    for (std::size_t i = 0; i < world.contacts.size(); ++i) {
        const bool began = (step.work.contactKeys[i] & kKeyBegan) != 0;
        if (!began && !world.settings.stayEvents) continue;
        const Contact& contact = world.contacts[i];
        if ((contact.flags & kTouching) == 0) continue;
        report(world, step.work, contact, began ? ContactPhase::Began : ContactPhase::Stayed);
    }
    publishSurfaces(world, step.work);
}

}  // namespace plumb::physics
