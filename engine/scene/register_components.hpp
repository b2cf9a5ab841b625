#pragma once

namespace plumb {

class TypeRegistry;

/// Registers all components of the scene layer, in the order in which files and the inspector list them.
void registerSceneComponents(TypeRegistry& types);

}  // namespace plumb
