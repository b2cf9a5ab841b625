#pragma once

#include "physics/workspace.hpp"
#include "physics/world.hpp"

namespace plumb::physics {

// A surface is made of shapes (ShapeDefinition::surface) and has seams that nobody should hear of. So
// contacts with it are counted by who touches it: the first to begin is its event, and the last to end, at
// the end of the step, when those that took over from each other are known.

/// Makes an event of what happened to a contact, if somebody wants to hear of it: at once, or with
/// publishSurfaces().
void report(World& world, Workspace& work, const Contact& contact, ContactPhase phase);

/// Makes the events of surfaces. Part of publishing.
void publishSurfaces(World& world, Workspace& work);

/// Counts all contacts of surfaces anew, after the world was written over.
void countSurfaces(const World& world, Workspace& work);

}  // namespace plumb::physics
