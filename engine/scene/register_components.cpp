#include "scene/register_components.hpp"

#include "reflect/type_registry.hpp"
#include "scene/components.hpp"

namespace plumb {

void registerSceneComponents(TypeRegistry& types) { addAll(types, SceneComponents{}); }

}  // namespace plumb
