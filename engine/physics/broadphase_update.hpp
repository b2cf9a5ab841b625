#pragma once

#include "physics/workspace.hpp"
#include "physics/world.hpp"

namespace plumb::physics {

/// The world's shapes as its broad phase sees them.
[[nodiscard]] Proxies proxiesOf(const World& world);

/// Tells the broad phase of all that changed since it was last told; fills the workspace anew after the world
/// was written over. Steps and queries begin with it. It changes nothing that a step's outcome depends on.
void updateBroadPhase(World& world, Workspace& work);

}  // namespace plumb::physics
