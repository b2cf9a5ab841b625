#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>

#include "core/hash.hpp"
#include "reflect/type_builder.hpp"
#include "reflect/type_info.hpp"
#include "reflect/type_key.hpp"
#include "reflect/type_name.hpp"

namespace plumb {

/// Description of a component type for the storage. One per type in the program, never freed.
struct ComponentType {
    TypeInfo info;               ///< without fields when the type is not described
    std::string name;            ///< the described name, else the compiler's
    std::uint64_t nameHash = 0;  ///< orders types where the order is visible: TypeKeys differ between builds
    bool namesTiles = false;     ///< a field refers to a grid of the TileStore
};

/// Returns the description of a type, created by the first call for it; for a type of code that was loaded
/// again, by the first call of each version that differs. Thread-safe.
const ComponentType& componentTypeOf(const TypeInfo& info);
/// Replaces the description of a type, e.g. after its code was loaded again; registers it if it is new.
/// @pre worlds with components of the type convert them before they are used again: World::convert
const ComponentType& updateComponentType(const TypeInfo& info);
/// The description of a type that is already registered, or nullptr.
const ComponentType* findComponentType(TypeKey key);
/// The same by its name.
const ComponentType* findComponentType(std::string_view name);

/// Adds a component to a hash: by its fields where they are described, else by its bytes.
void hashComponent(Hasher& hasher, const TypeInfo& type, const void* component);

/// The description of T. Not inlined, to keep it out of loops that may be the first to use T.
template <class T>
[[gnu::noinline]] const ComponentType& componentType() {
    static_assert(std::is_trivially_copyable_v<T>,
                  "components are plain data; use ids for variable-size data");
    static const ComponentType& type = [&]() -> const ComponentType& {
        TypeInfo info;
        if constexpr (Described<T>) {
            TypeBuilder<T> builder{info};
            T::describe(builder);
        } else {
            info.key = typeKey<T>();
            info.size = kIsTag<T> ? 0 : sizeof(T);
            info.alignment = alignof(T);
            if constexpr (std::is_default_constructible_v<T>) {
                info.defaults = defaultBytes<T>();
            }
        }
        if (info.name.empty()) info.name = compilerTypeName<T>();
        return componentTypeOf(info);
    }();
    return type;
}

}  // namespace plumb
