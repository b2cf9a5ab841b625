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

namespace plumb {

/// A component type as the storage sees it. One per type and program, never freed.
struct ComponentType {
    TypeInfo info;               ///< without fields when the type is not described
    std::string name;            ///< the described name, else the compiler's
    std::uint64_t nameHash = 0;  ///< orders types where the order is visible: keys differ between builds
    bool namesTiles = false;     ///< a field of it refers to a grid of the TileStore
};

/// The description of a type; the first one registered is kept. Thread-safe.
const ComponentType& componentTypeOf(const TypeInfo& info);
/// The description of a type that is already registered, or nullptr.
const ComponentType* findComponentType(TypeKey key);

/// Adds a component to a hash: by its fields where they are described, else by its bytes.
void hashComponent(Hasher& hasher, const TypeInfo& type, const void* component);

/// A type's name as the compiler writes it, with its namespaces.
template <class T>
constexpr std::string_view compilerTypeName() {
#if defined(_MSC_VER) && !defined(__clang__)
    constexpr std::string_view text = __FUNCSIG__;
    constexpr std::size_t open = text.find("compilerTypeName<") + 17;
    constexpr std::size_t start = text.find(' ', open) < text.rfind(">(") ? text.find(' ', open) + 1 : open;
    constexpr std::string_view name = text.substr(start, text.rfind(">(") - start);
    return name.substr(0, 7) == "plumb::" ? name.substr(7) : name;
#else
    constexpr std::string_view text = __PRETTY_FUNCTION__;
    constexpr std::size_t start = text.find("T = ") + 4;
    constexpr std::size_t end = text.find(';', start) < text.size() ? text.find(';', start) : text.rfind(']');
    // Compilers differ in whether they print the namespace of this function, so it is
    // always removed: the name is hashed, and the hash must be the same everywhere.
    constexpr std::string_view inside = "plumb::";
    constexpr std::string_view name = text.substr(start, end - start);
    return name.substr(0, inside.size()) == inside ? name.substr(inside.size()) : name;
#endif
}

/// The same without the namespaces: "GravitySystem".
template <class T>
constexpr std::string_view shortTypeName() {
    constexpr std::string_view name = compilerTypeName<T>();
    constexpr std::size_t colon = name.substr(0, name.find('<')).rfind(':');
    return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

/// Not inlined, to keep it out of loops that may be the first to use a type.
template <class T>
[[gnu::noinline]] const ComponentType& componentType() {
    static_assert(std::is_trivially_copyable_v<T>, "components are plain data; hold what has a length by id");
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
                info.construct = [](void* memory) { std::construct_at(static_cast<T*>(memory)); };
            }
        }
        if (info.name.empty()) info.name = compilerTypeName<T>();
        return componentTypeOf(info);
    }();
    return type;
}

}  // namespace plumb
