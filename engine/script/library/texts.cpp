#include <cmath>
#include <cstring>

#include <lua.hpp>

#include "script/library/library_parts.hpp"

namespace plumb::script {
namespace {

/// printf writes NaN with and without a sign.
bool pushSpecialNumber(lua_State* state, int index) {
    if (lua_type(state, index) != LUA_TNUMBER || lua_isinteger(state, index)) return false;
    const lua_Number number = lua_tonumber(state, index);
    if (std::isfinite(number)) return false;
    lua_pushstring(state, std::isnan(number) ? "nan" : number > 0.0 ? "inf" : "-inf");
    return true;
}

int toText(lua_State* state) {
    luaL_checkany(state, 1);
    pushText(state, 1);
    return 1;
}

/// Returns the end of a format specification that starts after '%'.
const char* endOfSpecification(const char* at) {
    at += std::strspn(at, "-+ #0123456789.");
    return *at == '\0' ? at : at + 1;
}

/// string.format: replaces arguments of %s that are no strings by their texts, and calls Lua's own function,
/// the upvalue.
int formatText(lua_State* state) {
    const char* format = luaL_checkstring(state, 1);
    const int count = lua_gettop(state);
    int argument = 1;
    for (const char* at = std::strchr(format, '%'); at != nullptr; at = std::strchr(at, '%')) {
        if (at[1] == '%') {
            at += 2;
            continue;
        }
        const char* end = endOfSpecification(at + 1);
        const char kind = end[-1];
        ++argument;
        if (kind == 'p' || kind == 'a' || kind == 'A')
            return luaL_error(state, "format: %%%c writes something else on each machine", kind);
        if (argument <= count && (kind == 's' || pushSpecialNumber(state, argument))) {
            if (kind == 's') pushText(state, argument);
            if (kind != 's')
                return luaL_error(state, "format: argument %d is %s", argument, lua_tostring(state, -1));
            lua_replace(state, argument);
        }
        at = end;
    }
    lua_pushvalue(state, lua_upvalueindex(1));
    lua_insert(state, 1);
    lua_call(state, count, 1);
    return 1;
}

}  // namespace

void pushText(lua_State* state, int index) {
    index = lua_absindex(state, index);
    if (pushSpecialNumber(state, index)) return;
    switch (lua_type(state, index)) {
        case LUA_TNIL:
        case LUA_TBOOLEAN:
        case LUA_TNUMBER:
        case LUA_TSTRING: luaL_tolstring(state, index, nullptr); return;
        default: break;
    }
    if (luaL_callmeta(state, index, "__tostring") != 0) {
        if (lua_isstring(state, -1) == 0) luaL_error(state, "'__tostring' must return a string");
        return;
    }
    if (luaL_getmetafield(state, index, "__name") == LUA_TSTRING) return;
    lua_pushstring(state, luaL_typename(state, index));
}

void addTexts(lua_State* state) {
    lua_pushcfunction(state, toText);
    lua_setglobal(state, "tostring");
    lua_getglobal(state, LUA_STRLIBNAME);
    lua_getfield(state, -1, "format");
    lua_pushcclosure(state, formatText, 1);
    lua_setfield(state, -2, "format");
    lua_pop(state, 1);
}

}  // namespace plumb::script
