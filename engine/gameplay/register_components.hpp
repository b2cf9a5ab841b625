#pragma once

namespace plumb {

class TypeRegistry;

/// Makes the ready-made parts of games known to files, the inspector and scripts, in the order in which those
/// list them.
void registerGameplayComponents(TypeRegistry& types);

}  // namespace plumb
