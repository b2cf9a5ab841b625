#pragma once

#include "reflect/entity_id.hpp"
#include "reflect/type_info.hpp"

struct lua_State;

namespace plumb {

/// Watches the lines of scripts as they run, and may end the scripts of a tick: a debugger. A service of
/// worlds; without it scripts run without a hook. Lines of files being loaded and of coroutines that scripts
/// create are not seen.
class ScriptObserver {
public:
    virtual ~ScriptObserver() = default;

    /// False: scripts run without a hook for now.
    [[nodiscard]] virtual bool watches() const = 0;
    /// True: no handler begins or goes on any more. The world is not usable then: a snapshot must be
    /// restored.
    [[nodiscard]] virtual bool abandons() const = 0;

    /// A handler begins, or goes on after it has waited.
    /// @param script  component type of the script
    virtual void handlerBegins(EntityId entity, TypeKey script) = 0;
    /// A line is about to run.
    /// @param file   "scripts/slime.lua"
    /// @param depth  number of functions being called, 1 in the handler itself
    /// @return false to abandon the scripts of this tick; abandons() must be true from then on
    virtual bool onLine(lua_State* coroutine, const char* file, int line, int depth) = 0;
    /// The handler has ended, waits or has failed. Not called after onLine() has returned false.
    virtual void handlerEnds() = 0;
};

namespace script {

/// The result of resumeHandler() if the scripts of this tick are abandoned. No status of Lua.
inline constexpr int kAbandoned = -1;

/// As lua_resume(), watched by an observer.
/// @param observer  may be null
int resumeHandler(ScriptObserver* observer, lua_State* coroutine, lua_State* from, int values, int& results,
                  EntityId entity, TypeKey script);

}  // namespace script
}  // namespace plumb
