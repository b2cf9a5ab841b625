#pragma once

#include <cstdint>
#include <string_view>
#include <type_traits>

#include "reflect/type_info.hpp"
#include "reflect/type_name.hpp"

namespace plumb {

/// Upper limit of keys, so that tables indexed by key need no bounds check.
inline constexpr TypeKey kMaxTypes = 2048;

/// A key for another type. @param name  for messages about it; copied
TypeKey nextTypeKey(std::string_view name = {});
/// The name that a key was created with, as the compiler writes it; empty if it has none.
std::string_view typeNameOf(TypeKey key);

/// The first key that was created with this name; kMaxTypes if there is none.
TypeKey findTypeKey(std::string_view name);

/// The key of a type of a project's code, which is loaded again after a change: each version gets the same
/// key. Types of unnamed namespaces get another key in each call for a version, because two files may use the
/// same name; the next version gets the same keys, but maybe for other types of this name.
TypeKey reloadableTypeKey(std::string_view name);
/// To be called before another version of a project's code is loaded.
void beginReloadableTypes();
/// Number of the version of a project's code that was loaded last: of calls of beginReloadableTypes().
std::uint32_t reloadableVersion();
/// True if the type belongs to a project's code that is loaded again after a change.
bool isReloadable(TypeKey key);

template <class T>
#if defined(PLUMB_RELOADABLE)
inline const TypeKey kTypeKey = reloadableTypeKey(compilerTypeName<T>());
#else
inline const TypeKey kTypeKey = nextTypeKey(compilerTypeName<T>());
#endif

/// The key of a type in this program, const or not.
template <class T>
TypeKey typeKey() {
    return kTypeKey<std::remove_const_t<T>>;
}

/// A type without members: a tag.
template <class T>
inline constexpr bool kIsTag = std::is_empty_v<T>;

}  // namespace plumb
