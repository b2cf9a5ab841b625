#pragma once

#include "core/random.hpp"

struct lua_State;

// Parts of the library of scripts. Errors of Lua leave C++ functions by longjmp: no object with a destructor
// may exist where a function of Lua can fail.

namespace plumb::script {

/// pairs(), next(), table.sort(), setmetatable().
void addOrder(lua_State* state);
/// tostring() and string.format().
void addTexts(lua_State* state);
/// string.find(), match(), gmatch() and gsub().
void addSearch(lua_State* state);
/// Functions of math.
void addMath(lua_State* state);
/// pcall(), xpcall(), coroutine.resume() and close().
void addCalls(lua_State* state);
/// table.insert(), remove(), move() and concat().
void addLists(lua_State* state);
/// rawset().
void addProtection(lua_State* state);

/// Raises an error if the value at an index cannot be the `__call` of a metatable.
void checkCall(lua_State* state, int index);

/// Replaces the table on top of the stack by one that shows it and cannot be changed.
void pushReadOnly(lua_State* state);

/// Pushes the text of the value at an index, like tostring().
void pushText(lua_State* state, int index);

/// The generator of the host. Raises an error if there is no host.
Random& hostRandom(lua_State* state);

}  // namespace plumb::script
