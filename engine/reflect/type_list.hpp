#pragma once

namespace plumb {

/// An ordered list of types.
template <class... T>
struct TypeList {};

/// Adds all types of a list to a TypeRegistry.
template <class Registry, class... T>
void addAll(Registry& types, TypeList<T...>) {
    (types.template add<T>(), ...);
}

}  // namespace plumb
