#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/result.hpp"

struct lua_State;

namespace plumb {

class ScriptSet;

namespace script {

/// Number of rounds of loops and of calls that a handler may take. A round takes 10 to 50 ns, so a handler
/// that never ends is stopped within 50 ms.
inline constexpr long long kRounds = 1'000'000;

/// Adds everything that scripts use to a new state.
void openScripts(lua_State* state);

/// Runs a file, with global variables of its own, unless it has run already, and pushes what it returned.
/// require() is the same for scripts.
/// @param name  of the file, without folder and ending
/// @return false after pushing a message
bool runFile(lua_State* state, const ScriptSet& files, std::string_view name);
/// Makes the next runFile() run a file again.
void forgetFile(lua_State* state, std::string_view name);

/// Pushes the table of what each file has returned, by name; false while it runs.
void pushFileResults(lua_State* state);

/// Returns the names of the functions of the table on top of the stack, in the order of their bytes.
std::vector<std::string> functionNames(lua_State* state);

/// Allows kRounds for what runs next.
void resetBudget(lua_State* state);

}  // namespace script
}  // namespace plumb
