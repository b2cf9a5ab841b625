#include "script/script_list.hpp"

#include <lua.hpp>

namespace plumb::script {
namespace {

// Keys in the metatable of a protected list, by address.
constexpr char kItems = 0;  // the table of its items
constexpr char kField = 0;  // name of the field

/// Pushes a value of the metatable of the protected list at index 1.
void pushOfList(lua_State* state, const char& key) {
    lua_getmetatable(state, 1);
    lua_rawgetp(state, -1, &key);
}

int refuseItem(lua_State* state) {
    pushOfList(state, kField);
    const char* field = lua_tostring(state, -1);
    return luaL_error(state,
                      "the value of the field \"%s\" is read-only; assign a whole table: local items = { "
                      "table.unpack(self.%s) }, change items, self.%s = items",
                      field, field, field);
}

int countItems(lua_State* state) {
    pushOfList(state, kItems);
    lua_pushinteger(state, static_cast<lua_Integer>(lua_rawlen(state, -1)));
    return 1;
}

/// The items of a field are never changed, so pairs() may visit them themselves.
int visitItems(lua_State* state) {
    lua_getglobal(state, "pairs");
    pushOfList(state, kItems);
    lua_remove(state, -2);
    lua_call(state, 1, 3);
    return 3;
}

}  // namespace

void protectList(lua_State* state, std::string_view field) {
    const int items = lua_gettop(state);
    lua_newtable(state);
    lua_createtable(state, 0, 7);
    lua_pushvalue(state, items);
    lua_rawsetp(state, -2, &kItems);
    lua_pushlstring(state, field.data(), field.size());
    lua_rawsetp(state, -2, &kField);
    lua_pushvalue(state, items);
    lua_setfield(state, -2, "__index");
    lua_pushcfunction(state, refuseItem);
    lua_setfield(state, -2, "__newindex");
    lua_pushcfunction(state, countItems);
    lua_setfield(state, -2, "__len");
    lua_pushcfunction(state, visitItems);
    lua_setfield(state, -2, "__pairs");
    lua_pushboolean(state, 0);
    lua_setfield(state, -2, "__metatable");
    lua_setmetatable(state, -2);
    lua_replace(state, items);
}

void pushItems(lua_State* state, int index) {
    const int list = lua_absindex(state, index);
    if (lua_getmetatable(state, list) != 0) {
        if (lua_rawgetp(state, -1, &kItems) == LUA_TTABLE) return lua_remove(state, -2);
        lua_pop(state, 2);
    }
    lua_pushvalue(state, list);
}

}  // namespace plumb::script
