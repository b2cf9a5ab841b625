#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "core/result.hpp"
#include "reflect/entity_id.hpp"

struct lua_State;

namespace plumb {

class World;

namespace script {

/// Returns the string at an index; a description if the value is no string.
std::string textAt(lua_State* state, int index);

/// Calls `body`, in which functions of Lua may raise errors. @return false after pushing the message of one
bool callProtected(lua_State* state, const std::function<void()>& body);

/// Returns file and line of the innermost function of a script that is being called: "scripts/slime.lua:4".
std::string placeOf(lua_State* coroutine);

/// Returns the error with which a handler has ended: file and line, the entity, the functions that were being
/// called, and the local variables of the innermost one.
/// @param coroutine  of the handler, after lua_resume() has failed
/// @param status     what lua_resume() has returned
Error handlerError(lua_State* coroutine, int status, const World& world, EntityId entity);

/// Errors of handlers in one pass over all scripts. Many entities may fail in the same line: the first error
/// there is written in full, the others are counted. Not part of the simulation.
class FailureLog {
public:
    /// Counts an error at a place. @return true if it is the first one there
    bool isFirst(const std::string& place);
    /// Writes how many more there were at each place, and forgets them.
    void logOthers();

private:
    struct Place {
        std::string name;
        std::size_t others = 0;  // errors after the first
    };
    std::vector<Place> places_;  // in the order of their first errors
};

}  // namespace script
}  // namespace plumb
