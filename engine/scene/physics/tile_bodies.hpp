#pragma once

#include "ecs/world.hpp"
#include "scene/components/colliders/tile_collider.hpp"
#include "scene/components/drawing/tile_layer.hpp"
#include "scene/physics/physics_state.hpp"

namespace plumb {

/// Returns the tile size of a layer (px): its own, or that of its tileset.
Vec2 tileSizeOf(const World& world, const TileLayer& layer);

/// Updates terrains from their tile layers; after changes of cells only the parts around them are recreated.
/// @param all  true if an entity may have gained or lost a tile layer or tile collider
void followTiles(World& world, PhysicsState& state, bool all);

}  // namespace plumb
