#pragma once

#include "reflect/type_info.hpp"

namespace plumb {

/// Values at two addresses, by value: 0 equals -0 only in bits that files can tell apart, so it does not
/// here.
bool valuesEqual(const FieldInfo& field, const void* a, const void* b);

/// The same field of two objects of its type.
bool fieldsEqual(const FieldInfo& field, const void* a, const void* b);

/// All fields, the transient ones too.
bool componentsEqual(const TypeInfo& type, const void* a, const void* b);

void copyField(const FieldInfo& field, void* to, const void* from);

}  // namespace plumb
