#pragma once

namespace plumb {

/// Several types, in an order.
template <class... T>
struct TypeList {};

/// Adds all of them to a TypeRegistry.
template <class Registry, class... T>
void addAll(Registry& types, TypeList<T...>) {
    (types.template add<T>(), ...);
}

}  // namespace plumb
