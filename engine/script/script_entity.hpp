#pragma once

#include <string_view>

#include "reflect/entity_id.hpp"
#include "reflect/type_info.hpp"

struct lua_State;

namespace plumb {

class TypeRegistry;

namespace script {

// Entities and their components as values of Lua. `entity.rigidBody` is the component RigidBody, or nil;
// `entity.rigidBody.velocity` is its field. Handles of the same entity are equal.

/// Adds handles of entities and components to a new state.
void addEntities(lua_State* state);
/// Makes components of these types accessible, also after a type was changed. To be called before scripts
/// run.
void followTypes(lua_State* state, const TypeRegistry& types);

/// Pushes the handle of an entity; nil for the empty id.
void pushEntity(lua_State* state, EntityId entity);
/// Returns the entity at an index, a handle or the `self` of a script; the empty id if the value is none.
EntityId entityAt(lua_State* state, int index);
/// Returns the entity that is argument number `index`. Raises an error if it is none or does not exist any
/// more.
EntityId checkEntity(lua_State* state, int index);

/// Pushes the handle of a component. @pre the entity has it
void pushComponent(lua_State* state, EntityId entity, const TypeInfo& type);

/// Makes the table on top of the stack, which it removes, the functions of the scripts whose component has
/// this type: `self.NAME` is a field of the table self, a function, a property, or a member of the entity, in
/// this order.
void defineSelf(lua_State* state, const TypeInfo& type);
/// Makes the table on top of the stack the `self` of a script. @pre defineSelf()
void becomeSelf(lua_State* state, TypeKey type);

/// A component at an index of the stack.
struct ComponentHandle {
    EntityId entity;
    const TypeInfo* type = nullptr;
};
/// Returns the component that is argument number `index`, of a `self` that of its script; raises an error if
/// it is none.
ComponentHandle checkComponent(lua_State* state, int index);

/// Pushes "Transform has no field "positon"; did you mean "position"?". @return a negative number
int failUnknownField(lua_State* state, const TypeInfo& type, std::string_view name);

/// Sets fields of a component to the values of the table at an index.
/// @return false after pushing a message
bool setFields(lua_State* state, int table, EntityId entity, const TypeInfo& type);

}  // namespace script
}  // namespace plumb
