#include "gameplay/register_components.hpp"

#include "gameplay/components.hpp"
#include "reflect/type_registry.hpp"

namespace plumb {

namespace {

template <class... T>
void addAll(TypeRegistry& types, TypeList<T...>) {
    (types.add<T>(), ...);
}

}  // namespace

void registerGameplayComponents(TypeRegistry& types) { addAll(types, GameplayComponents{}); }

}  // namespace plumb
