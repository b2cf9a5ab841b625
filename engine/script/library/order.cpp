#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>

#include <lua.hpp>

#include "script/library/library_parts.hpp"
#include "script/library/work.hpp"

namespace plumb::script {
namespace {

constexpr std::int64_t kWorkPerKey = 30;

/// Rank of the type of a key in the order of pairs(); kNoOrder for types without an order.
enum Rank : int { kNumber, kString, kBoolean, kNoOrder };

Rank rankOf(lua_State* state, int index) {
    switch (lua_type(state, index)) {
        case LUA_TNUMBER: return kNumber;
        case LUA_TSTRING: return kString;
        case LUA_TBOOLEAN: return kBoolean;
        default: return kNoOrder;
    }
}

bool stringsInOrder(lua_State* state, int a, int b) {
    std::size_t lengthA = 0;
    std::size_t lengthB = 0;
    const char* textA = lua_tolstring(state, a, &lengthA);
    const char* textB = lua_tolstring(state, b, &lengthB);
    const int order = std::memcmp(textA, textB, std::min(lengthA, lengthB));
    return order != 0 ? order < 0 : lengthA < lengthB;
}

/// True if the key at index `a` comes before the one at `b`.
bool keysInOrder(lua_State* state, int a, int b) {
    const Rank rankA = rankOf(state, a);
    const Rank rankB = rankOf(state, b);
    if (rankA != rankB) return rankA < rankB;
    switch (rankA) {
        case kNumber: return lua_compare(state, a, b, LUA_OPLT) != 0;
        case kString: return stringsInOrder(state, a, b);
        default: return lua_toboolean(state, a) < lua_toboolean(state, b);
    }
}

bool callInOrder(lua_State* state, int a, int b) {
    constexpr int kFunction = 2;  // the argument of table.sort
    lua_pushvalue(state, kFunction);
    lua_pushvalue(state, a);
    lua_pushvalue(state, b);
    lua_call(state, 2, 1);
    const bool inOrder = lua_toboolean(state, -1) != 0;
    lua_pop(state, 1);
    return inOrder;
}
bool valuesInOrder(lua_State* state, int a, int b) { return lua_compare(state, a, b, LUA_OPLT) != 0; }

using InOrder = bool (*)(lua_State* state, int a, int b);

/// Merges two sorted runs of a list: from..middle and middle..end, offsets from 0. The order of equal values
/// stays.
void merge(lua_State* state, int list, InOrder inOrder, const lua_Integer* from, lua_Integer* to,
           lua_Integer begin, lua_Integer middle, lua_Integer end) {
    lua_Integer left = begin;
    lua_Integer right = middle;
    for (lua_Integer at = begin; at < end; ++at) {
        bool takesRight = left == middle;
        if (!takesRight && right < end) {
            lua_rawgeti(state, list, from[right]);
            lua_rawgeti(state, list, from[left]);
            takesRight = inOrder(state, lua_gettop(state) - 1, lua_gettop(state));
            lua_pop(state, 2);
        }
        to[at] = takesRight ? from[right++] : from[left++];
    }
}

/// Sorts the values 1..count of the list at an index by merging, and pushes the sorted list. Never fails by
/// itself, even if `inOrder` is no order.
void pushSorted(lua_State* state, int list, lua_Integer count, InOrder inOrder) {
    constexpr std::int64_t kWorkPerComparison = 30;
    const auto rounds = static_cast<std::int64_t>(std::bit_width(static_cast<std::uint64_t>(count)));
    spend(state, kWorkPerComparison * count * rounds);
    // Memory of the state, so that an error of the comparison loses nothing.
    auto* from = static_cast<lua_Integer*>(
        lua_newuserdatauv(state, static_cast<std::size_t>(count + 1) * 2 * sizeof(lua_Integer), 0));
    lua_Integer* to = from + count + 1;
    for (lua_Integer i = 0; i < count; ++i) from[i] = i + 1;
    for (lua_Integer width = 1; width < count; width *= 2) {
        for (lua_Integer begin = 0; begin < count; begin += 2 * width)
            merge(state, list, inOrder, from, to, begin, std::min(begin + width, count),
                  std::min(begin + 2 * width, count));
        std::swap(from, to);
    }
    lua_createtable(state, static_cast<int>(std::min<lua_Integer>(count, 1 << 20)), 0);
    for (lua_Integer i = 0; i < count; ++i) {
        lua_rawgeti(state, list, from[i]);
        lua_rawseti(state, -2, i + 1);
    }
    lua_remove(state, -2);
}

int sort(lua_State* state) {
    luaL_checktype(state, 1, LUA_TTABLE);
    const lua_Integer count = std::max<lua_Integer>(luaL_len(state, 1), 0);
    if (!lua_isnoneornil(state, 2)) luaL_checktype(state, 2, LUA_TFUNCTION);
    lua_settop(state, 2);
    constexpr lua_Integer kMax = 1 << 24;
    luaL_argcheck(state, count < kMax, 1, "the list is too long to be sorted");
    lua_createtable(state, static_cast<int>(count), 0);
    for (lua_Integer i = 1; i <= count; ++i) {
        lua_geti(state, 1, i);
        lua_rawseti(state, 3, i);
    }
    pushSorted(state, 3, count, lua_isnil(state, 2) ? valuesInOrder : callInOrder);
    for (lua_Integer i = 1; i <= count; ++i) {
        lua_rawgeti(state, -1, i);
        lua_seti(state, 1, i);
    }
    return 0;
}

/// The sorted keys of the table at index 1, as a list on top of the stack.
void pushKeys(lua_State* state) {
    lua_newtable(state);
    const int keys = lua_gettop(state);
    lua_Integer count = 0;
    bool sorted = true;
    for (lua_pushnil(state); lua_next(state, 1) != 0;) {
        lua_pop(state, 1);
        spend(state, kWorkPerKey);
        if (rankOf(state, -1) == kNoOrder)
            luaL_error(
                state,
                "pairs: a key is a %s; only numbers, strings and booleans have the same order in every run",
                luaL_typename(state, -1));
        if (count > 0 && sorted) {
            lua_rawgeti(state, keys, count);
            sorted = keysInOrder(state, lua_gettop(state), lua_gettop(state) - 1);
            lua_pop(state, 1);
        }
        lua_pushvalue(state, -1);
        lua_rawseti(state, keys, ++count);
    }
    if (sorted) return;
    pushSorted(state, keys, count, keysInOrder);
    lua_remove(state, keys);
}

/// The iterator of pairs(): upvalues are the keys and the index of the last one. Keys that were removed are
/// skipped.
int nextOfPairs(lua_State* state) {
    lua_settop(state, 1);
    for (lua_Integer i = lua_tointeger(state, lua_upvalueindex(2)) + 1;; ++i) {
        if (lua_rawgeti(state, lua_upvalueindex(1), i) == LUA_TNIL) return 1;
        lua_pushvalue(state, -1);
        if (lua_rawget(state, 1) == LUA_TNIL) {
            lua_pop(state, 2);
            continue;
        }
        lua_pushinteger(state, i);
        lua_replace(state, lua_upvalueindex(2));
        return 2;
    }
}

int pairs(lua_State* state) {
    luaL_checkany(state, 1);
    if (luaL_getmetafield(state, 1, "__pairs") != LUA_TNIL) {
        lua_pushvalue(state, 1);
        lua_call(state, 1, 3);
        return 3;
    }
    luaL_checktype(state, 1, LUA_TTABLE);
    pushKeys(state);
    lua_pushinteger(state, 0);
    lua_pushcclosure(state, nextOfPairs, 2);
    lua_pushvalue(state, 1);
    lua_pushnil(state);
    return 3;
}

/// The key after one in the order of pairs(), by looking at all keys.
int next(lua_State* state) {
    luaL_checktype(state, 1, LUA_TTABLE);
    lua_settop(state, 2);
    const bool first = lua_isnil(state, 2);
    if (!first && rankOf(state, 2) == kNoOrder) luaL_argerror(state, 2, "keys of this type have no order");
    lua_pushnil(state);  // the best key so far
    for (lua_pushnil(state); lua_next(state, 1) != 0;) {
        lua_pop(state, 1);
        spend(state, kWorkPerKey);
        if (rankOf(state, 4) == kNoOrder) {
            // Still tells whether a table is empty.
            if (first && lua_isnil(state, 3)) lua_copy(state, 4, 3);
            continue;
        }
        const bool after = first || keysInOrder(state, 2, 4);
        const bool better = lua_isnil(state, 3) || rankOf(state, 3) == kNoOrder || keysInOrder(state, 4, 3);
        if (after && better) lua_copy(state, 4, 3);
    }
    if (lua_isnil(state, 3)) return 1;
    lua_pushvalue(state, 3);
    lua_rawget(state, 1);
    return 2;
}

/// Without finalizers and weak tables: when they act depends on the collector. `__call` must be a function: a
/// call of a table whose __call is a table takes Lua minutes if that leads back to it.
int setMetatable(lua_State* state) {
    luaL_checktype(state, 1, LUA_TTABLE);
    luaL_argexpected(state, lua_isnil(state, 2) || lua_istable(state, 2), 2, "nil or table");
    if (luaL_getmetafield(state, 1, "__metatable") != LUA_TNIL)
        return luaL_error(state, "cannot change a protected metatable");
    if (lua_istable(state, 2)) {
        for (const char* name : {"__gc", "__mode"}) {
            lua_pushstring(state, name);
            if (lua_rawget(state, 2) != LUA_TNIL)
                return luaL_error(state, "%s is not available: when it acts would differ between runs", name);
            lua_pop(state, 1);
        }
        lua_pushliteral(state, "__call");
        lua_rawget(state, 2);
        checkCall(state, lua_gettop(state));
    }
    lua_settop(state, 2);
    lua_setmetatable(state, 1);
    return 1;
}

}  // namespace

void addOrder(lua_State* state) {
    lua_pushcfunction(state, pairs);
    lua_setglobal(state, "pairs");
    lua_pushcfunction(state, next);
    lua_setglobal(state, "next");
    lua_pushcfunction(state, setMetatable);
    lua_setglobal(state, "setmetatable");
    lua_getglobal(state, LUA_TABLIBNAME);
    lua_pushcfunction(state, sort);
    lua_setfield(state, -2, "sort");
    lua_pop(state, 1);
}

}  // namespace plumb::script
