#include "script/script_library.hpp"

#include <array>

#include <lua.hpp>

#include "script/library/library_parts.hpp"
#include "script/library/work.hpp"

namespace plumb {
namespace {

thread_local ScriptHost* currentHost = nullptr;

int print(lua_State* state) {
    const int count = lua_gettop(state);
    luaL_Buffer line;
    luaL_buffinit(state, &line);
    for (int i = 1; i <= count; ++i) {
        if (i > 1) luaL_addchar(&line, '\t');
        script::pushText(state, i);
        luaL_addvalue(&line);
    }
    luaL_pushresult(&line);
    std::size_t length = 0;
    const char* text = lua_tolstring(state, -1, &length);
    script::spendText(state, length);
    if (currentHost != nullptr) currentHost->print({text, length});
    return 0;
}

/// Removes these functions from the table on top of the stack.
template <std::size_t N>
void remove(lua_State* state, const std::array<const char*, N>& names) {
    for (const char* name : names) {
        lua_pushnil(state);
        lua_setfield(state, -2, name);
    }
}

void open(lua_State* state, const char* name, lua_CFunction function) {
    luaL_requiref(state, name, function, 1);
    lua_pop(state, 1);
}

void removeUnsafe(lua_State* state) {
    lua_pushglobaltable(state);
    remove(state, std::array{"collectgarbage", "dofile", "load", "loadfile", "require", "warn"});
    lua_getfield(state, -1, LUA_STRLIBNAME);
    remove(state, std::array{"dump"});
    lua_pop(state, 2);
    // package.loaded and the metatable of strings are not reachable either.
    lua_pushnil(state);
    lua_setfield(state, LUA_REGISTRYINDEX, LUA_LOADED_TABLE);
    lua_pushliteral(state, "");
    lua_getmetatable(state, -1);
    lua_pushboolean(state, 0);
    lua_setfield(state, -2, "__metatable");
    lua_pop(state, 2);
}

}  // namespace

ScriptHostScope::ScriptHostScope(ScriptHost& host) : before_{currentHost} {
    currentHost = &host;
    if (before_ == nullptr) script::Work::begin();
}
ScriptHostScope::~ScriptHostScope() {
    currentHost = before_;
    if (before_ == nullptr) script::Work::end();
}

namespace script {

Random& hostRandom(lua_State* state) {
    if (currentHost == nullptr) luaL_error(state, "random numbers are not available here");
    return currentHost->random();
}

}  // namespace script

void openScriptLibrary(lua_State* state) {
    open(state, LUA_GNAME, luaopen_base);
    open(state, LUA_TABLIBNAME, luaopen_table);
    open(state, LUA_STRLIBNAME, luaopen_string);
    open(state, LUA_MATHLIBNAME, luaopen_math);
    open(state, LUA_COLIBNAME, luaopen_coroutine);
    open(state, LUA_UTF8LIBNAME, luaopen_utf8);
    removeUnsafe(state);
    script::addOrder(state);
    script::addTexts(state);
    script::addSearch(state);
    script::addMath(state);
    script::addCalls(state);
    script::addLists(state);
    script::addProtection(state);
    lua_pushcfunction(state, print);
    lua_setglobal(state, "print");
    for (const char* name : {LUA_TABLIBNAME, LUA_STRLIBNAME, LUA_MATHLIBNAME, LUA_COLIBNAME, LUA_UTF8LIBNAME})
        makeReadOnly(state, name);
}

void makeReadOnly(lua_State* state, const char* global) {
    lua_getglobal(state, global);
    script::pushReadOnly(state);
    lua_setglobal(state, global);
}

void pushScriptEnvironment(lua_State* state) {
    lua_newtable(state);
    lua_pushvalue(state, -1);
    lua_setfield(state, -2, LUA_GNAME);
    lua_createtable(state, 0, 2);
    lua_pushglobaltable(state);
    lua_setfield(state, -2, "__index");
    lua_pushboolean(state, 0);
    lua_setfield(state, -2, "__metatable");
    lua_setmetatable(state, -2);
}

}  // namespace plumb
