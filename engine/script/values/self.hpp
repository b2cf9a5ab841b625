#pragma once

#include "reflect/entity_id.hpp"
#include "reflect/type_info.hpp"

struct lua_State;

namespace plumb::script {

// `self` of a script: a table whose names are also the properties of the script, its functions, and the
// members of its entity.

/// Prepares a new state.
void addSelves(lua_State* state);
/// Makes the table on top of the stack, which it removes, the functions of the scripts whose component has
/// this type: `self.NAME` is a field of the table self, a function, a property, or a member of the entity, in
/// this order.
void defineSelf(lua_State* state, const TypeInfo& type);
/// Makes the table on top of the stack, whose field `entity` is the handle of an entity, the `self` of a
/// script of this entity. @pre defineSelf()
void becomeSelf(lua_State* state, TypeKey type);
/// Ends a script and frees the reference to its `self` in the registry.
void endSelf(lua_State* state, int self);
/// Returns the component type of the script whose `self` is at an index; null if the value is none.
const TypeInfo* typeOfSelf(lua_State* state, int index);

/// Returns the entity of the `self` at an index, also after its script has ended; of another table that of
/// its field `entity`; or the empty id.
EntityId entityOfSelf(lua_State* state, int index);

/// Pushes the component of this type of the entity whose handle is at an index; `self` of the script that has
/// this type; nil if the entity has none.
void pushIfThere(lua_State* state, int handle, EntityId entity, const TypeInfo& type);

}  // namespace plumb::script
