#pragma once

#include <string>
#include <vector>

#include "core/result.hpp"
#include "reflect/json_fwd.hpp"
#include "reflect/type_info.hpp"

namespace plumb {

class FieldContext;

/// A problem with one key of a component.
struct FieldProblem {
    std::string key;  ///< the key in the file; empty if the whole component is invalid
    Error error;
};

/// Returns the fields that differ from `defaults`, in the order of `describe`, without transient ones.
Json componentToJson(const TypeInfo& type, const void* object, const void* defaults,
                     const FieldContext& context);

/// Sets the fields that are in the file; the others, and those with a problem, keep their values.
/// Each problem adds one entry; its `error.where` is "Type.field".
void componentFromJson(const TypeInfo& type, void* object, const Json& json, FieldContext& context,
                       std::vector<FieldProblem>& problems);

}  // namespace plumb
