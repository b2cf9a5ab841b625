#pragma once

#include <list>
#include <string_view>
#include <vector>

#include "core/assert.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// The component types of a program, in the order in which files and the inspector list them.
class TypeRegistry {
public:
    /// Registers a type by its `describe`; does nothing if it is registered already. mistakesOf() checks it.
    template <Described T>
    const TypeInfo& add() {
        if (const TypeInfo* known = find(typeKey<T>())) return *known;
        TypeInfo& type = types_.emplace_back();
        TypeBuilder<T> builder{type};
        T::describe(builder);
        return type;
    }

    /// Replaces the description of the type of this name, or adds it. References to the TypeInfo stay valid,
    /// those to its fields only if there are as many fields as before.
    const TypeInfo& update(TypeInfo type);
    /// The type of this name is no longer found. References to it stay valid.
    void remove(std::string_view name);

    template <class T>
    [[nodiscard]] const TypeInfo& of() const {
        const TypeInfo* type = find(typeKey<T>());
        PLUMB_ASSERT(type != nullptr, "this type was never added to the registry");
        return *type;
    }

    [[nodiscard]] const TypeInfo* find(std::string_view name) const;
    [[nodiscard]] const TypeInfo* find(TypeKey key) const;
    [[nodiscard]] const std::list<TypeInfo>& all() const { return types_; }
    [[nodiscard]] std::vector<std::string_view> names() const;

private:
    std::list<TypeInfo> types_;  // a list, so that references to its elements stay valid
    std::list<TypeInfo> removed_;
};

}  // namespace plumb
