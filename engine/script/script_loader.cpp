#include "script/script_loader.hpp"

#include <algorithm>
#include <string>

#include <lua.hpp>

#include "core/text.hpp"
#include "script/library/work.hpp"
#include "script/script_context.hpp"
#include "script/script_declaration.hpp"
#include "script/script_entity.hpp"
#include "script/script_errors.hpp"
#include "script/script_functions.hpp"
#include "script/script_library.hpp"
#include "script/script_set.hpp"
#include "script/script_source.hpp"
#include "script/script_vector.hpp"

namespace plumb::script {
namespace {

// Keys in the registry of the Lua state, by address.
constexpr char kBudgetHolder = 0;  // function whose first upvalue is the budget that all files share
constexpr char kResults = 0;       // what each file returned, by name; false while it runs
constexpr char kFiles = 0;         // address of the ScriptSet for require()

int stopHandler(lua_State* state) {
    return luaL_error(state,
                      "it takes more than a million rounds of loops and calls; use wait() in long loops");
}

int require(lua_State* state) {
    const std::string_view name = checkText(state, 1);
    lua_rawgetp(state, LUA_REGISTRYINDEX, &kFiles);
    const auto* files = static_cast<const ScriptSet*>(lua_touserdata(state, -1));
    lua_pop(state, 1);
    if (!runFile(state, *files, name)) return lua_error(state);
    return 1;
}

void addBudget(lua_State* state) {
    constexpr const char* kText = "local budget = 0 return function() return budget end";
    if (luaL_loadstring(state, kText) != LUA_OK || lua_pcall(state, 0, 1, 0) != LUA_OK) lua_error(state);
    lua_rawsetp(state, LUA_REGISTRYINDEX, &kBudgetHolder);
}

/// Makes the variable `name` of the function on top of the stack the budget of all files.
void shareBudget(lua_State* state) {
    const int function = lua_gettop(state);
    lua_rawgetp(state, LUA_REGISTRYINDEX, &kBudgetHolder);
    for (int i = 1;; ++i) {
        const char* name = lua_getupvalue(state, function, i);
        if (name == nullptr) break;
        lua_pop(state, 1);
        if (kBudget == name) lua_upvaluejoin(state, function, i, function + 1, 1);
    }
    lua_pop(state, 1);
}

/// Gives the function on top of the stack global variables of its own; those of all files are visible too.
void separateGlobals(lua_State* state) {
    const int function = lua_gettop(state);
    pushScriptEnvironment(state);
    for (int i = 1;; ++i) {
        const char* name = lua_getupvalue(state, function, i);
        if (name == nullptr) break;
        lua_pop(state, 1);
        if (std::string_view{name} != "_ENV") continue;
        lua_setupvalue(state, function, i);
        return;
    }
    lua_pop(state, 1);  // the file uses no global variable
}

/// Pushes the function of a file. @return false after pushing a message
bool loadFile(lua_State* state, const ScriptSet::File& file) {
    const std::string head = format("local {}, {} = ... return function(...) ", kBudget, kOverBudget);
    const std::string text = head + file.text + "\nend";
    const std::string name = "@" + file.path;
    if (luaL_loadbufferx(state, text.data(), text.size(), name.c_str(), "t") != LUA_OK) return false;
    lua_pushinteger(state, kRounds);
    lua_pushcfunction(state, stopHandler);
    if (lua_pcall(state, 2, 1, 0) != LUA_OK) return false;
    shareBudget(state);
    separateGlobals(state);
    return true;
}

}  // namespace

void openScripts(lua_State* state) {
    openScriptLibrary(state);
    addVectors(state);
    addDeclarations(state);
    addEntities(state);
    addBudget(state);
    lua_newtable(state);
    lua_rawsetp(state, LUA_REGISTRYINDEX, &kResults);
    lua_register(state, "require", require);
    addGlobalFunctions(state);
    makeReadOnly(state, "world");
    makeReadOnly(state, "input");
}

bool runFile(lua_State* state, const ScriptSet& files, std::string_view name) {
    lua_pushlightuserdata(state, const_cast<ScriptSet*>(&files));
    lua_rawsetp(state, LUA_REGISTRYINDEX, &kFiles);
    pushFileResults(state);
    const int results = lua_gettop(state);
    lua_pushlstring(state, name.data(), name.size());
    lua_rawget(state, results);
    if (lua_isboolean(state, -1) != 0) {
        lua_pushstring(state, "files require each other");
        return false;
    }
    if (lua_isnil(state, -1) == 0) {
        lua_remove(state, results);
        return true;
    }
    lua_settop(state, results);
    const ScriptSet::File* file = files.find(name);
    if (file == nullptr) {
        lua_pushliteral(state, "there is no file \"scripts/");
        lua_pushlstring(state, name.data(), name.size());
        lua_pushliteral(state, ".lua\"");
        lua_concat(state, 3);
        return false;
    }
    if (!loadFile(state, *file)) return false;
    const auto store = [&](int value) {
        lua_pushlstring(state, name.data(), name.size());
        lua_pushvalue(state, value);
        lua_rawset(state, results);
    };
    lua_pushboolean(state, 0);
    store(lua_gettop(state));
    lua_pop(state, 1);
    beginDeclaration(state);
    lua_insert(state, -2);
    const bool ran = lua_pcall(state, 0, 1, 0) == LUA_OK;
    lua_insert(state, -2);
    endDeclaration(state, name);
    if (ran && lua_istable(state, -1) == 0 && isDeclared(state, name)) {
        lua_pushliteral(state, "the file must end with `return` and the table that script{} has returned");
        return false;
    }
    if (ran && lua_isnil(state, -1) != 0) {
        lua_pop(state, 1);
        lua_newtable(state);
    }
    if (!ran) lua_pushnil(state);
    store(lua_gettop(state));
    if (!ran) lua_pop(state, 1);
    return ran;
}

void forgetFile(lua_State* state, std::string_view name) {
    pushFileResults(state);
    lua_pushlstring(state, name.data(), name.size());
    lua_pushnil(state);
    lua_rawset(state, -3);
    lua_pop(state, 1);
}

void pushFileResults(lua_State* state) { lua_rawgetp(state, LUA_REGISTRYINDEX, &kResults); }

std::vector<std::string> functionNames(lua_State* state) {
    std::vector<std::string> names;
    for (lua_pushnil(state); lua_next(state, -2) != 0; lua_pop(state, 1)) {
        if (lua_type(state, -2) == LUA_TSTRING && lua_isfunction(state, -1) != 0)
            names.push_back(textAt(state, -2));
    }
    std::sort(names.begin(), names.end());
    return names;
}

void resetBudget(lua_State* state) {
    Work::begin();
    lua_rawgetp(state, LUA_REGISTRYINDEX, &kBudgetHolder);
    lua_pushinteger(state, kRounds);
    lua_setupvalue(state, -2, 1);
    lua_pop(state, 1);
}

}  // namespace plumb::script
