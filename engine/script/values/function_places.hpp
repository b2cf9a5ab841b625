#pragma once

#include <string>

struct lua_State;

namespace plumb::script {

// Functions in a saved game: a function is named by the place where its file has it once it has run, such as
// the field `enter` of the table `idle` in the local variable `states` that onTick() of thing.lua uses. In
// another run, also of a later version of the game, the function at this place stands for it.

/// Notes the places of all functions of the files. To be called after files were loaded. Functions keep a
/// place that they have.
void noteFunctions(lua_State* state);

/// Returns the place of the value at an index, a function of a file or a function or table of the library;
/// empty if it has none, as a function that a handler has made.
std::string functionPlace(lua_State* state, int index);

/// Pushes the value at a place; nil if there is none.
void pushAtPlace(lua_State* state, const std::string& place);

/// Pushes an upvalue of the function at an index. @return its number; 0, and nothing is pushed, if there is
/// none
int pushUpvalue(lua_State* state, int function, const std::string& name);

}  // namespace plumb::script
