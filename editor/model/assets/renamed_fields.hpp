#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "reflect/type_registry.hpp"

namespace plumb::editor {

/// A text field of a component that names something of the project.
struct NamingField {
    const TypeInfo* type = nullptr;
    const FieldInfo* field = nullptr;
};

/// The text fields of all components that are called so: "action" names an action of the input map.
std::vector<NamingField> namingFields(const TypeRegistry& types, std::string_view name);

/// Exchanges a text where one of these fields holds it, in the JSON of a scene or a prefab. Everything else
/// stays byte for byte.
/// @param times  how often
std::string withRenamedFields(std::string_view json, const std::vector<NamingField>& fields,
                              std::string_view from, std::string_view to, int& times);

}  // namespace plumb::editor
