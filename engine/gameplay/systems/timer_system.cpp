#include "gameplay/systems/timer_system.hpp"

#include <algorithm>
#include <vector>

#include "ecs/world.hpp"
#include "gameplay/delayed_events.hpp"

namespace plumb {

void TimerSystem::update(World& world, float) {
    auto* delayed = world.findResource<DelayedEvents>();
    if (delayed == nullptr) return;
    followScenes(world, *delayed);
    std::vector<DelayedEvents::Entry>& entries = delayed->entries;
    // Take one entry at a time from the front, as emitDelayed() calls code of the game.
    while (!entries.empty() && entries.front().tick <= world.tick) {
        const DelayedEvents::Entry due = entries.front();
        entries.erase(entries.begin());
        emitDelayed(world, due);
    }
}

}  // namespace plumb
