#pragma once

#include "reflect/type_info.hpp"

namespace plumb {

/// Copies a component into one of another version of its type. Fields are found by their names, or by their
/// former names (FieldBuilder::was). A field that has not changed keeps its value. Numbers, bools and enums
/// are converted to one another (enums among themselves by name), rounded, and limited to the range of the
/// new field; lists keep the items that fit. All other fields keep the value that `to` has, and so do fields
/// with the default value of the previous version: a changed default reaches the components that never had
/// another value.
void convertComponent(const TypeInfo& before, const void* from, const TypeInfo& now, void* to);

/// True for bools, integers, floats and enums.
[[nodiscard]] bool isNumber(FieldKind kind);

/// The field of the former version whose value a field of the present one gets; null if there is none.
[[nodiscard]] const FieldInfo* formerField(const TypeInfo& before, const FieldInfo& field);

/// True if components of both versions have the same bytes, ranges and defaults: nothing has to be converted.
bool sameLayout(const TypeInfo& a, const TypeInfo& b);

}  // namespace plumb
