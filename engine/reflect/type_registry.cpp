#include "reflect/type_registry.hpp"

#include <algorithm>
#include <utility>

namespace plumb {

namespace {

auto named(std::list<TypeInfo>& types, std::string_view name) {
    return std::find_if(types.begin(), types.end(), [&](const TypeInfo& type) { return type.name == name; });
}

/// Replaces a description; equally many fields stay in place, as steps of an undo history refer to them.
void replace(TypeInfo& known, TypeInfo type) {
    if (known.fields.size() == type.fields.size()) {
        std::move(type.fields.begin(), type.fields.end(), known.fields.begin());
        type.fields = std::move(known.fields);
    }
    known = std::move(type);
}

}  // namespace

const TypeInfo& TypeRegistry::update(TypeInfo type) {
    auto found = named(types_, type.name);
    if (found == types_.end()) {
        const auto removed = named(removed_, type.name);
        if (removed == removed_.end()) return types_.emplace_back(std::move(type));
        types_.splice(types_.end(), removed_, removed);
        found = removed;
    }
    replace(*found, std::move(type));
    return *found;
}

void TypeRegistry::remove(std::string_view name) {
    const auto found = named(types_, name);
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
