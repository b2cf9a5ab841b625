#pragma once

#include "physics/shapes/hull.hpp"
#include "physics/world.hpp"

namespace plumb::physics {

/// Stores the corners of a hull in Shapes::corners, if possible in a block that freePolygon() returned.
Geometry storePolygon(Shapes& shapes, const Hull& hull, float radius);
void freePolygon(Shapes& shapes, const Geometry& polygon);

}  // namespace plumb::physics
