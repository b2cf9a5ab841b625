#pragma once

#include "physics/workspace.hpp"
#include "physics/world.hpp"

namespace plumb::physics {

/// Updates the broad phase with all changes since the last update; refills the workspace after the world was
/// overwritten. Steps and queries begin with it. The result of a step does not depend on it.
void updateBroadPhase(World& world, Workspace& work);

}  // namespace plumb::physics
