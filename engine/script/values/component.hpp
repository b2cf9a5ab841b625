#pragma once

#include <string_view>

#include "reflect/entity_id.hpp"
#include "reflect/type_info.hpp"

struct lua_State;

namespace plumb {

class World;

namespace script {

// Components as values of Lua: `entity.rigidBody.velocity` is a field of a component.

/// A component of an entity, which may be gone.
struct ComponentHandle {
    EntityId entity;
    const TypeInfo* type = nullptr;
};

/// Adds handles of components to a new state.
void addComponents(lua_State* state);
/// Makes the fields of a type accessible, also after the type was changed.
void followFields(lua_State* state, const TypeInfo& type);

/// Pushes the handle of a component. @pre the entity has it
void pushComponent(lua_State* state, EntityId entity, const TypeInfo& type);
/// The same for the entity whose handle is at an index of the stack.
void pushComponentOf(lua_State* state, int handle, EntityId entity, const TypeInfo& type);

/// Returns the component that is argument number `index`, of a `self` that of its script; raises an error if
/// it is none.
ComponentHandle checkComponent(lua_State* state, int index);
/// Raises an error: the entity, or its component, is gone.
int goneComponent(lua_State* state, const ComponentHandle& handle);

/// Pushes "Transform has no field "positon"; did you mean "position"?". @return a negative number
int failUnknownField(lua_State* state, const TypeInfo& type, std::string_view name);
/// Sets the field of a component to the value at an index; raises an error if it does not fit.
void setField(lua_State* state, int index, World& world, const TypeInfo& type, const FieldInfo& field,
              void* component);
/// Sets fields of a component to the values of the table at an index.
/// @return false after pushing a message
bool setFields(lua_State* state, int table, EntityId entity, const TypeInfo& type);

}  // namespace script
}  // namespace plumb
