#include <lua.hpp>

#include "script/library/library_parts.hpp"
#include "script/library/work.hpp"

// pcall() and the like. What ends a script cannot be caught: otherwise it could go on filling its memory, and
// each attempt costs a search for garbage.

namespace plumb::script {
namespace {

/// Counts an error that is to be caught. @return false if too many were
bool mayCatch() {
    constexpr std::int64_t kWork = 200;  // its message, and leaving the functions
    return Work::spend(kWork);
}

/// @param extra  number of values on the stack that are no results
int finishCall(lua_State* state, int status, lua_KContext extra) {
    if (status == LUA_OK || status == LUA_YIELD) return lua_gettop(state) - static_cast<int>(extra);
    if (status == LUA_ERRMEM || !mayCatch()) return lua_error(state);
    lua_pushboolean(state, 0);
    lua_insert(state, -2);
    return 2;
}

int protectedCall(lua_State* state) {
    luaL_checkany(state, 1);
    lua_pushboolean(state, 1);  // the first result
    lua_insert(state, 1);
    return finishCall(state, lua_pcallk(state, lua_gettop(state) - 2, LUA_MULTRET, 0, 0, finishCall), 0);
}

int protectedCallWithHandler(lua_State* state) {
    constexpr int kHandler = 2;
    const int count = lua_gettop(state);
    luaL_checktype(state, kHandler, LUA_TFUNCTION);
    lua_pushboolean(state, 1);  // the first result
    lua_pushvalue(state, 1);
    lua_rotate(state, 3, 2);  // below the arguments
    const int status = lua_pcallk(state, count - 2, LUA_MULTRET, kHandler, kHandler, finishCall);
    return finishCall(state, status, kHandler);
}

/// coroutine.resume() or close(), the upvalue.
int callCoroutine(lua_State* state) {
    lua_State* thread = lua_tothread(state, 1);
    const int before = thread == nullptr ? LUA_OK : lua_status(thread);
    lua_pushvalue(state, lua_upvalueindex(1));
    lua_insert(state, 1);
    lua_call(state, lua_gettop(state) - 1, LUA_MULTRET);
    const bool failed = lua_toboolean(state, 1) == 0;
    const int after = thread == nullptr ? LUA_OK : lua_status(thread);
    const bool noMemory = after == LUA_ERRMEM && before != LUA_ERRMEM;
    if (failed && (noMemory || !mayCatch())) return lua_error(state);
    return lua_gettop(state);
}

void guardCoroutines(lua_State* state, const char* name) {
    lua_getfield(state, -1, name);
    lua_pushcclosure(state, callCoroutine, 1);
    lua_setfield(state, -2, name);
}

}  // namespace

void addCalls(lua_State* state) {
    lua_pushcfunction(state, protectedCall);
    lua_setglobal(state, "pcall");
    lua_pushcfunction(state, protectedCallWithHandler);
    lua_setglobal(state, "xpcall");
    lua_getglobal(state, LUA_COLIBNAME);
    guardCoroutines(state, "resume");
    guardCoroutines(state, "close");
    lua_pop(state, 1);
}

}  // namespace plumb::script
