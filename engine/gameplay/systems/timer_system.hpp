#pragma once

#include <string_view>

namespace plumb {

class World;

/// Emits delayed events (emitAfter) that are due.
/// Reads and writes: DelayedEvents. When: before all other systems.
struct TimerSystem {
    static constexpr std::string_view kName = "timers";

    void update(World& world, float dt);
};

}  // namespace plumb
