#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

#include <lua.hpp>

#include "script/library/library_parts.hpp"
#include "script/library/work.hpp"
#include "script/script_arena.hpp"

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
    std::size_t length = 0;
    const char* format = luaL_checklstring(state, 1, &length);
    const char* formatEnd = format + length;  // the text may contain the character 0
    const int count = lua_gettop(state);
    int argument = 1;
    for (const char* at = std::find(format, formatEnd, '%'); at != formatEnd;
         at = std::find(at, formatEnd, '%')) {
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

/// Fills memory with repetitions of its first `part` bytes.
void repeatBytes(char* memory, std::size_t part, std::size_t bytes) {
    for (std::size_t done = part; done < bytes;) {
        const std::size_t more = std::min(done, bytes - done);
        std::memcpy(memory + done, memory, more);
        done += more;
    }
}

/// string.rep, in few copies. Lua's own function, the upvalue, makes one for each time, without end for a
/// text of length 0; it has the errors for what is too long.
int repeat(lua_State* state) {
    std::size_t length = 0;
    std::size_t separatorLength = 0;
    const char* text = luaL_checklstring(state, 1, &length);
    const lua_Integer count = luaL_checkinteger(state, 2);
    const char* separator = luaL_optlstring(state, 3, "", &separatorLength);
    const std::size_t part = length + separatorLength;
    if (count <= 0 || part == 0) return lua_pushliteral(state, ""), 1;
    if (static_cast<std::uint64_t>(count) > ScriptArena::kBytes / part) {
        lua_settop(state, 3);
        lua_pushvalue(state, lua_upvalueindex(1));
        lua_insert(state, 1);
        lua_call(state, 3, 1);
        return 1;
    }
    const std::size_t bytes = part * static_cast<std::size_t>(count) - separatorLength;
    luaL_Buffer buffer;
    char* memory = luaL_buffinitsize(state, &buffer, bytes);
    std::memcpy(memory, text, length);
    if (count > 1) {
        std::memcpy(memory + length, separator, separatorLength);
        repeatBytes(memory, part, bytes);
    }
    luaL_pushresultsize(&buffer, bytes);
    return 1;
}

/// A function of Lua, the upvalue: its text, its arguments and its results are counted as work.
int countWork(lua_State* state) {
    std::size_t length = 0;
    if (lua_type(state, 1) == LUA_TSTRING) static_cast<void>(lua_tolstring(state, 1, &length));
    spendText(state, length);
    spend(state, lua_gettop(state));
    lua_pushvalue(state, lua_upvalueindex(1));
    lua_insert(state, 1);
    lua_call(state, lua_gettop(state) - 1, LUA_MULTRET);
    spend(state, lua_gettop(state));
    return lua_gettop(state);
}

/// Puts a function between scripts and the function of that name in the library on top of the stack.
void wrap(lua_State* state, const char* name, lua_CFunction function) {
    lua_getfield(state, -1, name);
    lua_pushcclosure(state, function, 1);
    lua_setfield(state, -2, name);
}

/// Wraps functions whose time grows with a text or the number of values.
void countLongOnes(lua_State* state) {
    for (const char* name : {"upper", "lower", "reverse", "pack", "unpack"}) wrap(state, name, countWork);
    lua_getglobal(state, LUA_UTF8LIBNAME);
    for (const char* name : {"len", "offset", "codepoint"}) wrap(state, name, countWork);
    lua_pop(state, 1);
    lua_getglobal(state, LUA_TABLIBNAME);
    wrap(state, "unpack", countWork);
    lua_pop(state, 1);
    lua_pushglobaltable(state);
    wrap(state, "select", countWork);
    lua_pop(state, 1);
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
    const int name = luaL_getmetafield(state, index, "__name");
    if (name == LUA_TSTRING) return;
    if (name != LUA_TNIL) lua_pop(state, 1);
    lua_pushstring(state, luaL_typename(state, index));
}

void addTexts(lua_State* state) {
    lua_pushcfunction(state, toText);
    lua_setglobal(state, "tostring");
    lua_getglobal(state, LUA_STRLIBNAME);
    wrap(state, "format", formatText);
    wrap(state, "rep", repeat);
    countLongOnes(state);
    lua_pop(state, 1);
}

}  // namespace plumb::script
