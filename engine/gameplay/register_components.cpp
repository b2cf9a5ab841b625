#include "gameplay/register_components.hpp"

#include "gameplay/components.hpp"
#include "reflect/type_registry.hpp"

namespace plumb {

void registerGameplayComponents(TypeRegistry& types) { addAll(types, GameplayComponents{}); }

}  // namespace plumb
