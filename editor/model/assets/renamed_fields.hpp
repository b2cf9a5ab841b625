#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "reflect/type_registry.hpp"

namespace plumb::editor {

/// A text field of a component that holds the name of a project item, such as an input action.
struct NamingField {
    const TypeInfo* type = nullptr;
    const FieldInfo* field = nullptr;
};

/// Returns all component fields of type text with this name, e.g. "action", which holds an input action.
std::vector<NamingField> namingFields(const TypeRegistry& types, std::string_view name);

/// Replaces the value `from` of these fields by `to` in the JSON text of a scene or prefab. All other bytes
/// stay unchanged.
/// @param times  increased by the number of replacements
std::string withRenamedFields(std::string_view json, const std::vector<NamingField>& fields,
                              std::string_view from, std::string_view to, int& times);

}  // namespace plumb::editor
