#pragma once

#include <deque>
#include <string_view>
#include <vector>

#include "core/assert.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// The component types of a program, in the order in which files and the inspector list them.
class TypeRegistry {
public:
    /// Registers a type by its `describe`; has no effect the second time.
    template <Described T>
    const TypeInfo& add() {
        if (const TypeInfo* known = find(typeKey<T>())) return *known;
        TypeInfo& type = types_.emplace_back();
        TypeBuilder<T> builder{type};
        T::describe(builder);
        PLUMB_ASSERT(!type.name.empty(), "a described type needs a name");
        return type;
    }

    template <class T>
    [[nodiscard]] const TypeInfo& of() const {
        const TypeInfo* type = find(typeKey<T>());
        PLUMB_ASSERT(type != nullptr, "this type was never added to the registry");
        return *type;
    }

    [[nodiscard]] const TypeInfo* find(std::string_view name) const;
    [[nodiscard]] const TypeInfo* find(TypeKey key) const;
    [[nodiscard]] const std::deque<TypeInfo>& all() const { return types_; }
    [[nodiscard]] std::vector<std::string_view> names() const;

private:
    std::deque<TypeInfo> types_;  // a deque, so that references to it stay valid
};

}  // namespace plumb
