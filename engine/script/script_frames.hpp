#pragma once

#include <string>
#include <string_view>
#include <vector>

struct lua_State;

namespace plumb {

struct ScriptVariable {
    std::string name;
    std::string value;
};

/// A function that is being called, as text.
struct ScriptFrame {
    std::string function;                   ///< "onTick"
    std::string file;                       ///< "scripts/slime.lua"
    int line = 0;                           ///< the line that runs
    std::vector<ScriptVariable> variables;  ///< local ones, then those of the functions around it
};

namespace script {

/// Number of functions being called in a coroutine.
int scriptDepth(lua_State* coroutine);

/// Returns the functions of scripts that are being called in a coroutine, innermost first. Calls no function
/// of a script.
std::vector<ScriptFrame> framesOf(lua_State* coroutine);
/// As framesOf(), without variables: needs neither memory nor stack of Lua, e.g. after these have ended.
std::vector<ScriptFrame> placesOf(lua_State* coroutine);

/// Value of an expression.
struct Evaluation {
    bool holds = false;   ///< it is neither nil nor false
    std::string value;    ///< as text
    std::string problem;  ///< why there is no value; empty: there is one
};

/// Evaluates an expression of Lua with the variables of the innermost function. Takes part of the time of a
/// handler at most.
Evaluation evaluate(lua_State* coroutine, std::string_view expression);

}  // namespace script
}  // namespace plumb
