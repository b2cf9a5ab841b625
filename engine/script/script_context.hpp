#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "reflect/entity_id.hpp"
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
    std::uint32_t ticks = 1;  ///< ticks to wait
    TextId event;             ///< name of the event to wait for; empty: the ticks
};

/// What the functions of scripts work on while scripts run in this thread.
struct Context {
    World& world;
    const ScriptSet& scripts;
    ScriptState& state;
    lua_State* handler = nullptr;  ///< coroutine of the handler that runs; null while files are loaded
    WaitRequest request;
};

/// Makes a context the current one of this thread as long as the object exists.
class ContextScope {
public:
    explicit ContextScope(Context& context);
    ~ContextScope();
    ContextScope(const ContextScope&) = delete;
    ContextScope& operator=(const ContextScope&) = delete;

private:
    Context* before_;
};

/// Returns the current context; null while no script of a world runs.
Context* currentContext();
/// Returns the current context. Raises an error of Lua if there is none: the file of a script is being
/// loaded.
Context& contextOf(lua_State* state);
inline World& worldOf(lua_State* state) { return contextOf(state).world; }

/// Returns the text that is argument number `index`; raises an error if it is none.
std::string_view checkText(lua_State* state, int index);

// Errors of Lua leave C++ functions by longjmp, which skips destructors. A function that has objects with
// destructors returns fail(), and is registered as guarded<function>, which raises the error after it
// returned.

/// Pushes a message. @return the value that tells guarded() to raise the error
int fail(lua_State* state, const std::string& message);
int raise(lua_State* state);

template <int (*Function)(lua_State*)>
int guarded(lua_State* state) {
    const int results = Function(state);
    return results < 0 ? raise(state) : results;
}

}  // namespace script
}  // namespace plumb
