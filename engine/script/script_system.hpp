#pragma once

#include <string_view>

namespace plumb {

class World;

/// True if an entity has a script, or a script of a removed component must be ended.
bool hasScripts(const World& world);

/// Begins and ends scripts, goes on with handlers that waited, and calls onTick.
/// Reads and writes: ScriptState, all that scripts access. When: before controllers and the physics.
struct ScriptSystem {
    static constexpr std::string_view kName = "scripts";

    void update(World& world, float dt);
};

/// Calls the handlers of contacts, triggers and events.
/// Reads and writes: ScriptState, all that scripts access. When: after the physics and gameplay.
struct ScriptEventSystem {
    static constexpr std::string_view kName = "script_events";

    void update(World& world, float dt);
};

}  // namespace plumb
