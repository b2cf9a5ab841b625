#include "reflect/type_registry.hpp"

#include <algorithm>
#include <utility>

namespace plumb {

const TypeInfo& TypeRegistry::update(TypeInfo type) {
    const auto found = std::find_if(types_.begin(), types_.end(),
                                    [&](const TypeInfo& known) { return known.name == type.name; });
    if (found == types_.end()) return types_.emplace_back(std::move(type));
    *found = std::move(type);
    return *found;
}

void TypeRegistry::remove(std::string_view name) {
    const auto found =
        std::find_if(types_.begin(), types_.end(), [&](const TypeInfo& known) { return known.name == name; });
    if (found != types_.end()) removed_.splice(removed_.end(), types_, found);
}

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
