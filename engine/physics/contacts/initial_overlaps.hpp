#pragma once

#include "physics/world.hpp"

namespace plumb::physics {

// Bodies that are put into each other (by a level, a script, a change of size) would be thrown apart. So an
// overlap that no motion explains is hidden from the solver when it begins, and shown little by little.

/// Marks a contact that begins deeper than the motion of its bodies explains: kInitialOverlap.
void markInitialOverlap(const World& world, Contact& contact);

/// Keeps how deep a marked contact is, and hides that from the solver.
void addInitialOverlap(World& world, Contact& contact);

/// Shows more of all that is hidden.
void fadeInitialOverlaps(World& world, float dt);

/// Hides from the solver what is still hidden of a marked contact; if nothing is, it is no longer marked.
void hideInitialOverlap(const World& world, Contact& contact);

}  // namespace plumb::physics
