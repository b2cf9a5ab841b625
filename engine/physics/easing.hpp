#pragma once

#include "physics/world.hpp"

namespace plumb::physics {

// Bodies that are put into each other (by a level, a script, a change of size) would be thrown apart. So of
// an overlap that no motion explains, a part is left alone: as deep as it is when it begins, and less and
// less.

/// A contact that begins takes note of how deep it is already.
void noteOverlap(const World& world, Contact& contact);

/// Hides from the solver what is left alone.
/// @pre some of it is: kEasing
void ease(const World& world, Contact& contact);

}  // namespace plumb::physics
