#include "script/values/function_places.hpp"

#include <algorithm>
#include <set>
#include <string_view>
#include <vector>

#include <lua.hpp>

#include "core/text.hpp"
#include "script/script_errors.hpp"
#include "script/script_loader.hpp"

// A place is a text of lines: the name of a file, or none for the library, and the steps from what the file
// has returned: a letter and the name.

namespace plumb::script {
namespace {

constexpr char kPlaces = 0;  // key in the registry of the Lua state, by address: the place of each function

enum Step : char { kField = '.', kItem = '#', kUpvalue = '^', kMetatable = 'm' };

std::string stepTo(const std::string& place, Step step, std::string_view name) {
    return format("{}\n{}{}", place, std::string(1, step), name);
}

void pushPlaces(lua_State* state) {
    if (lua_rawgetp(state, LUA_REGISTRYINDEX, &kPlaces) != LUA_TNIL) return;
    lua_pop(state, 1);
    lua_newtable(state);
    lua_createtable(state, 0, 1);  // forgets functions of former versions of files
    lua_pushliteral(state, "k");
    lua_setfield(state, -2, "__mode");
    lua_setmetatable(state, -2);
    lua_pushvalue(state, -1);
    lua_rawsetp(state, LUA_REGISTRYINDEX, &kPlaces);
}

/// True for a table that stands for one of the library, or for another one that scripts cannot change.
bool isProtected(lua_State* state, int table) {
    const bool is = luaL_getmetafield(state, table, "__metatable") != LUA_TNIL;
    if (is) lua_pop(state, 1);
    return is;
}

/// Visits what can be reached from the files, nearest first, so that a function gets its shortest place.
class Walk {
public:
    explicit Walk(lua_State* state) : state_{state} {
        pushPlaces(state);
        lua_newtable(state);
        places_ = lua_gettop(state) - 1;
        reached_ = lua_gettop(state);
    }

    /// Adds the value on top of the stack and pops it.
    void add(std::string place) {
        const bool isFunction = lua_isfunction(state_, -1) != 0 && lua_iscfunction(state_, -1) == 0;
        const bool isNew =
            (isFunction || lua_istable(state_, -1) != 0) && seen_.insert(lua_topointer(state_, -1)).second;
        if (!isNew) return lua_pop(state_, 1);
        if (isFunction) note(place);
        lua_rawseti(state_, reached_, static_cast<lua_Integer>(texts_.size()) + 1);
        texts_.push_back(std::move(place));
    }

    void run() {
        for (std::size_t i = 0; i < texts_.size(); ++i) {
            lua_rawgeti(state_, reached_, static_cast<lua_Integer>(i) + 1);
            lua_istable(state_, -1) != 0 ? visitTable(texts_[i]) : visitFunction(texts_[i]);
            lua_pop(state_, 1);
        }
    }

private:
    /// Gives the function on top of the stack its place.
    void note(const std::string& place) {
        lua_pushvalue(state_, -1);
        const bool has = lua_rawget(state_, places_) != LUA_TNIL;
        lua_pop(state_, 1);
        if (has) return;
        lua_pushvalue(state_, -1);
        lua_pushlstring(state_, place.data(), place.size());
        lua_rawset(state_, places_);
    }

    void visitTable(const std::string place) {
        for (lua_pushnil(state_); lua_next(state_, -2) != 0;) {
            const std::string name = lua_type(state_, -2) == LUA_TSTRING ? textAt(state_, -2) : "";
            if (!name.empty() && name.find('\n') == std::string::npos) {
                add(stepTo(place, kField, name));
            } else if (lua_isinteger(state_, -2) != 0) {
                add(stepTo(place, kItem, format("{}", lua_tointeger(state_, -2))));
            } else {
                lua_pop(state_, 1);
            }
        }
        if (!isProtected(state_, -1) && lua_getmetatable(state_, -1) != 0) add(stepTo(place, kMetatable, ""));
    }

    void visitFunction(const std::string place) {
        for (int i = 1; const char* name = lua_getupvalue(state_, -1, i); ++i)
            add(stepTo(place, kUpvalue, name));
    }

    lua_State* state_;
    int places_ = 0, reached_ = 0;
    std::vector<std::string> texts_;  // places of what was reached
    std::set<const void*> seen_;
};

/// Looks for a value at an index among the fields of the table on top of the stack, which it pops.
std::string fieldWith(lua_State* state, int value, const std::string& place, bool alsoInTables) {
    const int table = lua_gettop(state);
    std::string found;
    for (lua_pushnil(state); found.empty() && lua_next(state, table) != 0; lua_pop(state, 1)) {
        if (lua_type(state, -2) != LUA_TSTRING) continue;
        const std::string here = stepTo(place, kField, textAt(state, -2));
        if (lua_rawequal(state, -1, value) != 0) found = here;
        const bool isProxy =
            found.empty() && alsoInTables && luaL_getmetafield(state, -1, "__index") != LUA_TNIL;
        if (!isProxy) continue;
        if (lua_istable(state, -1) != 0) {
            found = fieldWith(state, value, here, false);
        } else {
            lua_pop(state, 1);
        }
    }
    lua_settop(state, table - 1);
    return found;
}

/// Replaces the value on top of the stack by what a step from it leads to; nil if there is nothing.
void take(lua_State* state, std::string_view step) {
    const std::string name{step.substr(1)};
    const int from = lua_gettop(state);
    const bool isTable = lua_istable(state, from) != 0;
    switch (step[0]) {
        case kField:
            lua_pushlstring(state, name.data(), name.size());
            if (isTable) {
                lua_rawget(state, from);
            } else {
                lua_pushnil(state);
            }
            // A table of the library is one that stands for it, see protection.cpp.
            if (isTable && lua_isnil(state, -1) != 0 &&
                luaL_getmetafield(state, from, "__index") == LUA_TTABLE) {
                lua_pushlstring(state, name.data(), name.size());
                lua_rawget(state, -2);
            }
            break;
        case kItem: {
            const auto item = parseInt(name);
            if (isTable && item) {
                lua_rawgeti(state, from, *item);
            } else {
                lua_pushnil(state);
            }
            break;
        }
        case kUpvalue:
            if (pushUpvalue(state, from, name) == 0) lua_pushnil(state);
            break;
        case kMetatable:
            if (!isTable || isProtected(state, from) || lua_getmetatable(state, from) == 0)
                lua_pushnil(state);
            break;
        default: lua_pushnil(state);
    }
    lua_replace(state, from);
    lua_settop(state, from);
}

}  // namespace

void noteFunctions(lua_State* state) {
    const int top = lua_gettop(state);
    pushFileResults(state);
    const int files = lua_gettop(state);
    Walk walk{state};
    for (lua_pushnil(state); lua_next(state, files) != 0;) walk.add(textAt(state, -2));
    walk.run();
    lua_settop(state, top);
}

std::string functionPlace(lua_State* state, int at) {
    const int index = lua_absindex(state, at);
    std::string place;
    if (lua_iscfunction(state, index) != 0 || (lua_istable(state, index) != 0 && isProtected(state, index))) {
        lua_pushglobaltable(state);
        return fieldWith(state, index, "", true);
    }
    if (lua_isfunction(state, index) == 0) return place;
    pushPlaces(state);
    lua_pushvalue(state, index);
    if (lua_rawget(state, -2) == LUA_TSTRING) place = textAt(state, -1);
    lua_pop(state, 2);
    return place;
}

void pushAtPlace(lua_State* state, const std::string& place) {
    std::string_view rest = place;
    const auto nextLine = [&rest] {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        const std::string_view line = rest.substr(0, end);
        rest.remove_prefix(std::min(end + 1, rest.size()));
        return line;
    };
    const std::string file{nextLine()};
    if (file.empty()) {
        lua_pushglobaltable(state);
    } else {
        pushFileResults(state);
        lua_pushlstring(state, file.data(), file.size());
        lua_rawget(state, -2);
        lua_remove(state, -2);
    }
    while (!rest.empty()) {
        const std::string_view step = nextLine();
        if (!step.empty()) take(state, step);
    }
}

int pushUpvalue(lua_State* state, int function, const std::string& name) {
    if (name.empty() || lua_isfunction(state, function) == 0) return 0;
    for (int i = 1; const char* upvalue = lua_getupvalue(state, function, i); ++i) {
        if (name == upvalue) return i;
        lua_pop(state, 1);
    }
    return 0;
}

}  // namespace plumb::script
