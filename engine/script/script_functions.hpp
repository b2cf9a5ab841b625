#pragma once

#include <span>

struct lua_State;

namespace plumb::script {

/// A function that scripts can call. The reference of scripts and the definitions for editors of text are
/// made from these rows.
struct ScriptFunction {
    const char* name;
    const char* signature;  ///< parameters and result: "(seconds: number)", "(name: string): Entity?"
    const char* doc;
    int (*function)(lua_State* state);
};

/// Functions that wait, emit events and change fields over time: wait(1.5).
std::span<const ScriptFunction> timeFunctions();
/// Functions that spawn entities, find them, play sounds, change scenes and query the physics:
/// spawn("prefabs/coin").
std::span<const ScriptFunction> gameFunctions();
/// Functions of entities: entity:destroy().
std::span<const ScriptFunction> entityFunctions();
/// Functions of the table `world`: world:query("Coin").
std::span<const ScriptFunction> worldFunctions();
/// Functions of the table `input`: input:isPressed("Jump").
std::span<const ScriptFunction> inputFunctions();

/// Implementation of entity:emit().
int emitTo(lua_State* state);

/// Adds functions to the table on top of the stack.
void addFunctions(lua_State* state, std::span<const ScriptFunction> functions);
/// Adds the functions of all groups but those of entities to a new state.
void addGlobalFunctions(lua_State* state);

}  // namespace plumb::script
