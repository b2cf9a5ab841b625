#pragma once

#include "physics/shapes/hull.hpp"
#include "physics/world.hpp"

namespace plumb::physics {

/// Puts the corners of a hull into the pool of all polygons. Freed places are used again.
Geometry storePolygon(Shapes& shapes, const Hull& hull, float radius);
void freePolygon(Shapes& shapes, const Geometry& polygon);

}  // namespace plumb::physics
