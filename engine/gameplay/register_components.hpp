#pragma once

namespace plumb {

class TypeRegistry;

/// Registers all components of the gameplay layer, in the
/// order in which files, the inspector and scripts list them.
void registerGameplayComponents(TypeRegistry& types);

}  // namespace plumb
