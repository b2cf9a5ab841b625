#pragma once

#include <string>
#include <vector>

#include "core/result.hpp"
#include "reflect/json_fwd.hpp"
#include "reflect/type_info.hpp"

namespace plumb {

class FieldContext;

/// A key of a component that could not be read as it stands.
struct FieldProblem {
    std::string key;  ///< as in the file; empty when the whole component is wrong
    Error error;
};

/// The fields that differ from `defaults`, in the order of `describe`; transient ones never.
Json componentToJson(const TypeInfo& type, const void* object, const void* defaults,
                     const FieldContext& context);

/// Sets the fields that the file names; the others keep their values, and so do those with a problem.
/// Every problem is one entry; its place is "Type.field".
void componentFromJson(const TypeInfo& type, void* object, const Json& json, FieldContext& context,
                       std::vector<FieldProblem>& problems);

}  // namespace plumb
