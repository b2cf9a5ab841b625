#pragma once

namespace plumb {

class TypeRegistry;

/// Adds every component of this layer, in the order in which files and the inspector list them.
void registerSceneComponents(TypeRegistry& types);

}  // namespace plumb
