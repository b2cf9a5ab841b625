#pragma once

#include "math/color.hpp"
#include "math/vec2.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// A grid of tiles, its top-left corner at the entity's Transform.
struct TileLayer {
    TilesetId tileset;
    TilesId cells;    ///< tile of each cell
    TilesId terrain;  ///< terrain id of each cell, from which the editor selected its tile
    Vec2 tileSize;    ///< px, size of a tile in the world; {0, 0}: the tileset's tile size
    int layer = 0;    ///< drawing layer; higher numbers are in front
    Color tint;

    static void describe(TypeBuilder<TileLayer>& type) {
        type.name("TileLayer").doc("A grid of tiles, its top-left corner at the entity's Transform.");
        type.field<&TileLayer::tileset>("tileset").doc("Tileset file of the layer.");
        type.field<&TileLayer::cells>("cells").doc("Tiles of the layer, painted with the tile tools.");
        type.field<&TileLayer::terrain>("terrain").doc(
            "Terrain painted in each cell, from which the tiles are selected.");
        type.field<&TileLayer::tileSize>("tileSize")
            .unit(Unit::Pixels)
            .doc("Size of a tile in the world, px; 0, 0: the tileset's tile size.");
        type.field<&TileLayer::layer>("layer")
            .range(-1000.0f, 1000.0f)
            .doc("Drawing layer; higher numbers are in front.");
        type.field<&TileLayer::tint>("tint").doc("Color multiplied with the tiles' colors.");
    }
};

}  // namespace plumb
