#pragma once

#include <string_view>

#include "core/random.hpp"

struct lua_State;

namespace plumb {

/// What scripts reach outside of their state while they run.
class ScriptHost {
public:
    virtual ~ScriptHost() = default;
    /// The random number generator behind math.random.
    virtual Random& random() = 0;
    /// Called by print().
    virtual void print(std::string_view text) = 0;
};

/// Sets the host of the scripts that run in this thread as long as the object exists. The outermost one
/// limits the work that functions of the library do.
class ScriptHostScope {
public:
    explicit ScriptHostScope(ScriptHost& host);
    ~ScriptHostScope();
    ScriptHostScope(const ScriptHostScope&) = delete;
    ScriptHostScope& operator=(const ScriptHostScope&) = delete;

private:
    ScriptHost* before_;
};

/// Adds the library of Lua to a new state, without all that reaches files, other programs, byte code or the
/// collector, and with the same results on every machine:
///
/// - pairs() and next() visit numbers in ascending order, then strings in the order of their bytes, then
/// false and true.
///   Keys of other types are an error of pairs(): they have no order that is the same in every run.
/// - table.sort() is stable.
/// - string.find() and the like stop with an error where a pattern needs millions of steps.
/// - Functions of the library do a limited amount of work in all within a ScriptHostScope.
/// - pcall() and the like do not catch the end of the memory or of that work.
/// - The tables of the library cannot be changed.
/// - math has the functions of math/portable.hpp, exact to about 7 digits, and pow(); math.random() is the
/// host's.
/// - tostring() and string.format("%s") write "table" and "function" instead of addresses.
void openScriptLibrary(lua_State* state);

/// Makes a global table, like "math", one that scripts cannot change.
void makeReadOnly(lua_State* state, const char* global);

/// Pushes an environment for a script: a table that shows the globals of the state, so that what a script
/// assigns to global names stays its own. `_G` is this table.
void pushScriptEnvironment(lua_State* state);

}  // namespace plumb
