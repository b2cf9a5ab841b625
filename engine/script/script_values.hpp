#pragma once

#include "reflect/type_info.hpp"
#include "script/script_event.hpp"

struct lua_State;

namespace plumb {

class World;

namespace script {

// Fields of components as values of Lua. Numbers, bools and texts are themselves; vectors are vec(x, y);
// entities are handles, or nil; enums are names; colors are "#rrggbbaa"; assets are paths; rectangles are {x,
// y, width, height}; lists are tables.

void pushValue(lua_State* state, World& world, const FieldInfo& field, const void* value);

/// Stores the value at an index. Numbers are limited to the range of the field.
/// @param type  name of the component, for messages
/// @return false after pushing a message: the value has another type, or is not finite
bool readValue(lua_State* state, int index, World& world, std::string_view type, const FieldInfo& field,
               void* value);

/// Returns the description of the items of a list.
FieldInfo itemOf(const FieldInfo& list);

/// Pushes a value of an event.
void pushValue(lua_State* state, World& world, const ScriptValue& value);

}  // namespace script
}  // namespace plumb
