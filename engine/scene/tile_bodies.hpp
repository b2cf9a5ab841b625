#pragma once

#include "ecs/world.hpp"
#include "box_physics/tile_field.hpp"
#include "scene/components/tile_layer.hpp"

namespace plumb {

/// The size of one tile of a layer (px): its own, or its tileset's.
Vec2 tileSizeOf(const World& world, const TileLayer& layer);

/// The solid cells of a tile layer in metres, each with the shape that its tileset gives it.
/// Without an AssetStore every tile is full.
box_physics::TileField tileFieldOf(const World& world, const TileLayer& layer);

}  // namespace plumb
