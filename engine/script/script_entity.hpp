#pragma once

#include "reflect/entity_id.hpp"

struct lua_State;

namespace plumb {

class TypeRegistry;

namespace script {

// Entities as values of Lua. `entity.rigidBody` is the component RigidBody, or nil. Handles of the same
// entity are equal.

/// Adds handles of entities, of their components and of scripts to a new state.
void addEntities(lua_State* state);
/// Makes components of these types accessible, also after a type was changed. To be called before scripts
/// run.
void followTypes(lua_State* state, const TypeRegistry& types);

/// Pushes the handle of an entity; nil for the empty id.
void pushEntity(lua_State* state, EntityId entity);
/// Returns the entity whose handle is at an index; the empty id if the value is none.
EntityId entityOfHandle(lua_State* state, int index);
/// Returns the entity at an index, a handle or the `self` of a script; the empty id if the value is none.
EntityId entityAt(lua_State* state, int index);
/// Returns the entity that is argument number `index`. Raises an error if it is none or does not exist any
/// more.
EntityId checkEntity(lua_State* state, int index);
/// Pushes what entities have: a table of functions, and of component types by name.
void pushMembers(lua_State* state);

}  // namespace script
}  // namespace plumb
