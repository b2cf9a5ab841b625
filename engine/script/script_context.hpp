#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "reflect/entity_id.hpp"
#include "script/library/work.hpp"
#include "script/script_event.hpp"

struct lua_State;

namespace plumb {

class ScriptSet;
class World;
struct ScriptState;
struct TypeInfo;

namespace script {

/// What a handler waits for: the request of wait() or waitFor(), read when its coroutine has yielded.
struct WaitRequest {
    std::uint32_t ticks = 1;  ///< ticks to wait at most; 0: without end, for an event
    TextId event;             ///< name of the event to wait for; empty: none
};

/// What the functions of scripts work on while scripts run in this thread.
struct Context {
    World& world;
    const ScriptSet& scripts;
    ScriptState& state;
    lua_State* handler = nullptr;  ///< coroutine of the handler that runs; null while files are loaded
    EntityId entity;               ///< whose handler it is
    WaitRequest request;
};

/// Makes a context the current one of this thread as long as the object exists.
class ContextScope {
public:
    explicit ContextScope(Context& context);
    ~ContextScope();
    ContextScope(const ContextScope&) = delete;
    ContextScope& operator=(const ContextScope&) = delete;

    /// The current context; null while no script of a world runs.
    static Context* current() { return current_; }

private:
    static inline constinit thread_local Context* current_ = nullptr;
    Context* before_;
};

inline Context* currentContext() { return ContextScope::current(); }
/// Raises an error of Lua: the file of a script is being loaded.
void failWithoutWorld(lua_State* state);
/// Returns the current context, for an access to the world. Raises an error of Lua if there is none.
inline Context& contextOf(lua_State* state) {
    constexpr std::int64_t kCallWork = 40;  // units of Work: 0.2 us, which a round of a loop does not count
    if (currentContext() == nullptr) failWithoutWorld(state);
    spend(state, kCallWork);
    return *currentContext();
}
inline World& worldOf(lua_State* state) { return contextOf(state).world; }

/// Returns the text that is argument number `index`; raises an error if it is none.
std::string_view checkText(lua_State* state, int index);

// Errors of Lua leave C++ functions by longjmp, which skips destructors. So an object with a destructor must
// not exist where an error is raised: a function that needs one for the message pushes it by fail(), and its
// caller raises the error by lua_error() after it has returned.

/// Pushes a message with file and line. @return a negative number
int fail(lua_State* state, const std::string& message);

}  // namespace script
}  // namespace plumb
