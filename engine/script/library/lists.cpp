#include <algorithm>
#include <cstdint>

#include <lua.hpp>

#include "script/library/library_parts.hpp"
#include "script/library/work.hpp"

// Functions of table that move values. Those of Lua run for years where a length or a range is 2^62.

namespace plumb::script {
namespace {

constexpr std::int64_t kWorkPerValue = 20;  // a metamethod may be a function of the library

lua_Integer lengthOf(lua_State* state) {
    luaL_checktype(state, 1, LUA_TTABLE);
    return luaL_len(state, 1);
}

/// Moves a value within or between the tables at two indices.
void moveValue(lua_State* state, int from, lua_Integer fromKey, int to, lua_Integer toKey) {
    spend(state, kWorkPerValue);
    lua_geti(state, from, fromKey);
    lua_seti(state, to, toKey);
}

lua_Integer after(lua_Integer n) {
    return static_cast<lua_Integer>(static_cast<lua_Unsigned>(n) + 1u);  // 2^63 - 1 wraps, as in Lua
}

int insert(lua_State* state) {
    const lua_Integer end = after(lengthOf(state));
    lua_Integer position = end;
    switch (lua_gettop(state)) {
        case 2: break;
        case 3: {
            position = luaL_checkinteger(state, 2);
            const bool inside = static_cast<lua_Unsigned>(position) - 1u < static_cast<lua_Unsigned>(end);
            luaL_argcheck(state, inside, 2, "position out of bounds");
            for (lua_Integer i = end; i > position; --i) moveValue(state, 1, i - 1, 1, i);
            break;
        }
        default: return luaL_error(state, "wrong number of arguments to 'insert'");
    }
    lua_seti(state, 1, position);
    return 0;
}

int remove(lua_State* state) {
    const lua_Integer length = lengthOf(state);
    lua_Integer position = luaL_optinteger(state, 2, length);
    if (lua_gettop(state) >= 2) {
        const lua_Unsigned offset =
            static_cast<lua_Unsigned>(length) + 1u - static_cast<lua_Unsigned>(position);
        luaL_argcheck(state, offset <= static_cast<lua_Unsigned>(length), 2, "position out of bounds");
    }
    lua_geti(state, 1, position);
    for (; position < length; ++position) moveValue(state, 1, position + 1, 1, position);
    lua_pushnil(state);
    lua_seti(state, 1, position);
    return 1;
}

/// True if the values must be moved from the last one on, because the ranges overlap.
bool movesBackward(lua_State* state, lua_Integer first, lua_Integer last, lua_Integer target, int to) {
    if (target > last || target <= first) return false;
    return to == 1 || lua_compare(state, 1, to, LUA_OPEQ) != 0;
}

int move(lua_State* state) {
    const lua_Integer first = luaL_checkinteger(state, 2);
    const lua_Integer last = luaL_checkinteger(state, 3);
    const lua_Integer target = luaL_checkinteger(state, 4);
    const int to = lua_isnoneornil(state, 5) ? 1 : 5;
    luaL_checktype(state, 1, LUA_TTABLE);
    luaL_checktype(state, to, LUA_TTABLE);
    if (last >= first) {
        luaL_argcheck(state, first > 0 || last < LUA_MAXINTEGER + first, 3, "too many elements to move");
        const lua_Integer most = last - first;  // offset of the last value
        luaL_argcheck(state, target <= LUA_MAXINTEGER - most, 4, "destination wrap around");
        const bool backward = movesBackward(state, first, last, target, to);
        for (lua_Integer i = 0; i <= most; ++i) {
            const lua_Integer at = backward ? most - i : i;
            moveValue(state, 1, first + at, to, target + at);
        }
    }
    lua_pushvalue(state, to);
    return 1;
}

void addField(lua_State* state, luaL_Buffer& out, lua_Integer index) {
    spend(state, kWorkPerValue);
    lua_geti(state, 1, index);
    if (lua_isstring(state, -1) == 0)
        luaL_error(state, "invalid value (at index %I) in table for 'concat'",
                   static_cast<LUAI_UACINT>(index));
    luaL_addvalue(&out);
}

int concat(lua_State* state) {
    const lua_Integer length = lengthOf(state);
    std::size_t separatorLength = 0;
    const char* separator = luaL_optlstring(state, 2, "", &separatorLength);
    lua_Integer index = luaL_optinteger(state, 3, 1);
    const lua_Integer last = luaL_optinteger(state, 4, length);
    luaL_Buffer out;
    luaL_buffinit(state, &out);
    for (; index < last; ++index) {
        addField(state, out, index);
        luaL_addlstring(&out, separator, separatorLength);
    }
    if (index == last) addField(state, out, index);
    luaL_pushresult(&out);
    return 1;
}

constexpr luaL_Reg kFunctions[] = {
    {"insert", insert}, {"remove", remove}, {"move", move}, {"concat", concat}, {nullptr, nullptr}};

}  // namespace

void addLists(lua_State* state) {
    lua_getglobal(state, LUA_TABLIBNAME);
    luaL_setfuncs(state, kFunctions, 0);
    lua_pop(state, 1);
}

}  // namespace plumb::script
