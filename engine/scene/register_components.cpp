#include "scene/register_components.hpp"

#include "reflect/type_registry.hpp"
#include "scene/components.hpp"

namespace plumb {

namespace {

template <class... T>
void addAll(TypeRegistry& types, TypeList<T...>) {
    (types.add<T>(), ...);
}

}  // namespace

void registerSceneComponents(TypeRegistry& types) { addAll(types, SceneComponents{}); }

}  // namespace plumb
