#pragma once

#include <string_view>

struct lua_State;

namespace plumb::script {

// Lists, rectangles and curves that are values of fields. A table of their items is a copy, so a change of it
// would be lost: such a table refuses changes, and says how to assign the field.

/// Replaces the table on top of the stack by one that shows its items and cannot be changed.
/// @param field  the field whose value it is, for errors
void protectList(lua_State* state, std::string_view field);

/// Pushes the table of the items of the table at an index: that itself, unless protectList() has made it.
void pushItems(lua_State* state, int index);

}  // namespace plumb::script
