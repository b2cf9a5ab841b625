#include "script/script_functions.hpp"

#include <lua.hpp>

namespace plumb::script {
namespace {

void addGlobals(lua_State* state, std::span<const ScriptFunction> functions) {
    lua_pushglobaltable(state);
    addFunctions(state, functions);
    lua_pop(state, 1);
}

void addTable(lua_State* state, const char* name, std::span<const ScriptFunction> functions) {
    lua_newtable(state);
    addFunctions(state, functions);
    lua_setglobal(state, name);
}

}  // namespace

void addFunctions(lua_State* state, std::span<const ScriptFunction> functions) {
    for (const ScriptFunction& function : functions) {
        lua_pushcfunction(state, function.function);
        lua_setfield(state, -2, function.name);
    }
}

void addGlobalFunctions(lua_State* state) {
    addGlobals(state, timeFunctions());
    addGlobals(state, gameFunctions());
    addTable(state, "world", worldFunctions());
    addTable(state, "input", inputFunctions());
}

}  // namespace plumb::script
