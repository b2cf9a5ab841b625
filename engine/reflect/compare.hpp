#pragma once

#include "reflect/type_info.hpp"

namespace plumb {

/// Compares the values at two addresses as
/// files store them: 0 and -0 are different.
bool valuesEqual(const FieldInfo& field, const void* a, const void* b);

/// Compares one field of two objects of the same type.
bool fieldsEqual(const FieldInfo& field, const void* a, const void* b);

/// Compares all fields, including transient ones.
bool componentsEqual(const TypeInfo& type, const void* a, const void* b);

void copyField(const FieldInfo& field, void* to, const void* from);

}  // namespace plumb
