#include "reflect/type_registry.hpp"

namespace plumb {

const TypeInfo* TypeRegistry::find(std::string_view name) const {
    for (const TypeInfo& type : types_) {
        if (type.name == name) return &type;
    }
    return nullptr;
}

const TypeInfo* TypeRegistry::find(TypeKey key) const {
    for (const TypeInfo& type : types_) {
        if (type.key == key) return &type;
    }
    return nullptr;
}

std::vector<std::string_view> TypeRegistry::names() const {
    std::vector<std::string_view> names;
    for (const TypeInfo& type : types_) {
        names.push_back(type.name);
    }
    return names;
}

}  // namespace plumb
