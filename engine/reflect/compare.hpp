#pragma once

#include "reflect/type_info.hpp"

namespace plumb {

/// True if the values at two addresses are equal
/// as files store them: 0 and -0 are different.
bool valuesEqual(const FieldInfo& field, const void* a, const void* b);

/// True if one field of two objects of the same type is equal.
bool fieldsEqual(const FieldInfo& field, const void* a, const void* b);

/// True if all fields are equal, including transient ones.
bool componentsEqual(const TypeInfo& type, const void* a, const void* b);

void copyField(const FieldInfo& field, void* to, const void* from);

}  // namespace plumb
