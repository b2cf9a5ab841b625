#pragma once

#include "physics/world.hpp"

namespace plumb::physics {

/// Applies the force of moving air to a shape, for the next step. Each face that the air hits adds drag along
/// the air and lift across it, away from the face, as for a flat plate. See also FieldKind::Wind.
/// @param air         m/s
/// @param drag, lift  kg/m2: half the density of the air times the drag or lift coefficient
Result<Done> applyWind(World& world, ShapeId shape, Vec2 air, float drag, float lift);

}  // namespace plumb::physics
