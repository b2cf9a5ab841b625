#include "script/script_observer.hpp"

#include <utility>

#include <lua.hpp>

#include "script/script_frames.hpp"

namespace plumb::script {
namespace {

/// What the hook reports to. The hook itself stays set in coroutines, also in snapshots of them.
struct Watched {
    ScriptObserver* observer = nullptr;
    lua_State* handler = nullptr;
};
thread_local Watched watched;

void onLine(lua_State* state, lua_Debug* at) {
    // Coroutines that scripts create inherit the hook, or not if they were created unwatched. None of them is
    // watched, so that a tick that is repeated has the same lines.
    if (watched.observer == nullptr || watched.handler != state) return;
    const int line = at->currentline;
    lua_getinfo(state, "S", at);
    const char* file = at->source[0] == '@' ? at->source + 1 : at->source;
    if (watched.observer->onLine(state, file, line, scriptDepth(state))) return;
    // A script that catches this error runs into the next one at its next line.
    lua_pushliteral(state, "the debugger has stopped this tick");
    lua_error(state);
}

}  // namespace

int resumeHandler(ScriptObserver* observer, lua_State* coroutine, lua_State* from, int values, int& results,
                  EntityId entity, TypeKey script) {
    if (observer == nullptr || !observer->watches()) {
        if (lua_gethook(coroutine) != nullptr) lua_sethook(coroutine, nullptr, 0, 0);
        return lua_resume(coroutine, from, values, &results);
    }
    if (observer->abandons()) return kAbandoned;
    observer->handlerBegins(entity, script);
    lua_sethook(coroutine, onLine, LUA_MASKLINE, 0);
    const Watched outer = std::exchange(watched, {observer, coroutine});
    const int status = lua_resume(coroutine, from, values, &results);
    watched = outer;
    if (observer->abandons()) return kAbandoned;
    observer->handlerEnds();
    return status;
}

}  // namespace plumb::script
