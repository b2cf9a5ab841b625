#pragma once

#include <string_view>

namespace plumb {

class World;

/// Emits delayed events (emitAfter) that are due; those of paused scenes rest, those of closed ones end.
/// Reads: LoadedScenes. Reads and writes: DelayedEvents. When: before all other systems.
struct TimerSystem {
    static constexpr std::string_view kName = "timers";

    void update(World& world, float dt);
};

}  // namespace plumb
