#include "gameplay/systems/timer_system.hpp"

#include "ecs/world.hpp"
#include "gameplay/delayed_events.hpp"

namespace plumb {

void TimerSystem::update(World& world, float) {
    auto* delayed = world.findResource<DelayedEvents>();
    if (delayed == nullptr) return;
    followScenes(world, *delayed);
    emitDue(world, *delayed);
}

}  // namespace plumb
