#pragma once

#include <string_view>
#include <type_traits>

#include "reflect/type_info.hpp"

namespace plumb {

/// Upper limit of keys, so that tables indexed by key need no bounds check.
inline constexpr TypeKey kMaxTypes = 2048;

TypeKey nextTypeKey();

template <class T>
inline const TypeKey kTypeKey = nextTypeKey();

/// The key of a type in this program, const or not.
template <class T>
TypeKey typeKey() {
    return kTypeKey<std::remove_const_t<T>>;
}

/// A type without members: a tag.
template <class T>
inline constexpr bool kIsTag = std::is_empty_v<T>;

}  // namespace plumb
