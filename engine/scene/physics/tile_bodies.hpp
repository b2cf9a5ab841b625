#pragma once

#include "ecs/world.hpp"
#include "scene/components/colliders/tile_collider.hpp"
#include "scene/components/drawing/tile_layer.hpp"
#include "scene/physics/physics_state.hpp"

namespace plumb {

/// The size of one tile of a layer (px): its own, or its tileset's.
Vec2 tileSizeOf(const World& world, const TileLayer& layer);

/// Terrains follow their tile layers; of a changed grid only the parts around changed cells are made anew.
/// @param all  an entity got or lost one
void followTiles(World& world, PhysicsState& state, bool all);

}  // namespace plumb
