#pragma once

#include <string>

#include "core/result.hpp"
#include "reflect/entity_id.hpp"

struct lua_State;

namespace plumb {

class World;

namespace script {

/// Returns the string at an index; a description if the value is no string.
std::string textAt(lua_State* state, int index);

/// Returns the error with which a handler has ended: file and line, the entity, the functions that were being
/// called, and the local variables of the innermost one.
/// @param coroutine  of the handler, after lua_resume() has failed
Error handlerError(lua_State* coroutine, const World& world, EntityId entity);

}  // namespace script
}  // namespace plumb
