#include "app/engine_types.hpp"

#include "gameplay/register_components.hpp"
#include "scene/register_components.hpp"

namespace plumb {

TypeRegistry engineTypes() {
    TypeRegistry types;
    registerSceneComponents(types);
    registerGameplayComponents(types);
    return types;
}

}  // namespace plumb
