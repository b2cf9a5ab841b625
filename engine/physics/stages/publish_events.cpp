#include <algorithm>

#include "physics/contacts/contacts.hpp"
#include "physics/stages.hpp"

namespace plumb::physics {

void publishEvents(StepContext& step) {
    World& world = step.world;
    const std::vector<std::uint16_t>& keys = step.work.contactKeys;
    std::sort(step.work.approaches.begin(), step.work.approaches.end());
    for (std::size_t i = 0; i < world.contacts.size(); ++i) {
        // Contacts of islands that woke after the narrow phase, e.g. by an explosion, have no key.
        const bool began = i < keys.size() && (keys[i] & kKeyBegan) != 0;
        if (!began && !world.settings.stayEvents) continue;
        const Contact& contact = world.contacts[i];
        if ((contact.flags & kTouching) == 0) continue;
        const std::vector<float>& impulses = step.work.stepImpulses;
        report(world, step.work, contact, began ? ContactPhase::Began : ContactPhase::Stayed,
               i < impulses.size() ? impulses[i] : 0.0f);
    }
    publishSurfaces(world, step.work);
}

}  // namespace plumb::physics
