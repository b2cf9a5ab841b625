#include <cstring>

#include <lua.hpp>

#include "script/library/library_parts.hpp"

// Tables that scripts cannot change: an empty table stands for the real one, which is reachable only by the
// metatable.

namespace plumb::script {
namespace {

int refuseWrite(lua_State* state) {
    return luaL_error(state, "tables of the library cannot be changed (field '%s')",
                      lua_type(state, 2) == LUA_TSTRING ? lua_tostring(state, 2) : luaL_typename(state, 2));
}

/// The metamethod of pairs(): visits a copy of the real table, the upvalue.
int visitCopy(lua_State* state) {
    lua_settop(state, 0);
    lua_getglobal(state, "pairs");
    lua_newtable(state);
    for (lua_pushnil(state); lua_next(state, lua_upvalueindex(1)) != 0;) {
        lua_pushvalue(state, -2);
        lua_insert(state, -2);
        lua_rawset(state, 2);
    }
    lua_call(state, 1, 3);
    return 3;
}

bool isReadOnly(lua_State* state, int index) {
    if (luaL_getmetafield(state, index, "__newindex") == LUA_TNIL) return false;
    const bool is = lua_tocfunction(state, -1) == refuseWrite;
    lua_pop(state, 1);
    return is;
}

int rawSet(lua_State* state) {
    luaL_checktype(state, 1, LUA_TTABLE);
    luaL_checkany(state, 2);
    luaL_checkany(state, 3);
    if (isReadOnly(state, 1)) return refuseWrite(state);
    if (lua_type(state, 2) == LUA_TSTRING && std::strcmp(lua_tostring(state, 2), "__call") == 0)
        checkCall(state, 3);
    lua_settop(state, 3);
    lua_rawset(state, 1);
    return 1;
}

}  // namespace

void checkCall(lua_State* state, int index) {
    if (lua_isnil(state, index) != 0 || lua_isfunction(state, index) != 0) return;
    luaL_error(state, "__call must be a function, found a %s", luaL_typename(state, index));
}

void addProtection(lua_State* state) {
    lua_pushcfunction(state, rawSet);
    lua_setglobal(state, "rawset");
}

void pushReadOnly(lua_State* state) {
    const int table = lua_gettop(state);
    lua_newtable(state);
    lua_createtable(state, 0, 4);
    lua_pushvalue(state, table);
    lua_setfield(state, -2, "__index");
    lua_pushcfunction(state, refuseWrite);
    lua_setfield(state, -2, "__newindex");
    lua_pushvalue(state, table);
    lua_pushcclosure(state, visitCopy, 1);
    lua_setfield(state, -2, "__pairs");
    lua_pushboolean(state, 0);
    lua_setfield(state, -2, "__metatable");
    lua_setmetatable(state, -2);
    lua_replace(state, table);
}

}  // namespace plumb::script
