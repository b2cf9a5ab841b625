#pragma once

#include "reflect/type_info.hpp"

namespace plumb {

/// Copies a component into one of another version of its type. Fields are found by their names, or by their
/// former names (FieldBuilder::was). A field whose kind is the same keeps its value; numbers, bools and enums
/// are converted to one another (enums among themselves by name) and limited to the range of the new field;
/// lists keep the items that fit. All other fields keep the value that `to` has, and so do fields with the
/// default value of the previous version: a changed default reaches the components that never had another
/// value.
void convertComponent(const TypeInfo& before, const void* from, const TypeInfo& now, void* to);

/// True if components of both versions have the same bytes and defaults: nothing has to be converted.
bool sameLayout(const TypeInfo& a, const TypeInfo& b);

}  // namespace plumb
