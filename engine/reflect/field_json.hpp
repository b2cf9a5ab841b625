#pragma once

#include "core/result.hpp"
#include "reflect/json_fwd.hpp"
#include "reflect/type_info.hpp"

namespace plumb {

class FieldContext;

/// Returns the value of a field as stored in files.
Json fieldToJson(const FieldInfo& field, const void* object, const FieldContext& context);

/// Reads a field from its form in files. A number outside the field's range is clamped, with a warning.
/// @error wrong type, not finite, an unknown name, a path that leaves the project; the field keeps its
/// value. `where` of the error is the field's name.
Result<Done> fieldFromJson(const FieldInfo& field, void* object, const Json& json, FieldContext& context);

/// Like fieldToJson() and fieldFromJson(), for a value at any address: an item of a list, or a copy.
Json valueToJson(const FieldInfo& field, const void* value, const FieldContext& context);
Result<Done> valueFromJson(const FieldInfo& field, void* value, const Json& json, FieldContext& context);

/// Short description of a value for messages: `"fast"`, `a list of 3`, `true`.
std::string foundText(const Json& json);

}  // namespace plumb
