#pragma once

#include "math/color.hpp"
#include "math/vec2.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// A grid of tiles, its top-left corner at the entity's Transform.
struct TileLayer {
    TilesetId tileset;
    TilesId cells;
    TilesId terrain;  ///< by cell the id of a terrain of the tileset, from which the editor chose its tile
    Vec2 tileSize;    ///< px in the world; {0, 0} takes the tileset's own
    int layer = 0;    ///< order of drawing: higher is in front
    Color tint;

    static void describe(TypeBuilder<TileLayer>& type) {
        type.name("TileLayer").doc("A grid of tiles, its top-left corner at the entity's Transform.");
        type.field<&TileLayer::tileset>("tileset").doc("The tileset file.");
        type.field<&TileLayer::cells>("cells").doc("The tiles, painted with the tile tools.");
        type.field<&TileLayer::terrain>("terrain").doc(
            "What is painted as terrain; the tiles follow from it.");
        type.field<&TileLayer::tileSize>("tileSize")
            .unit(Unit::Pixels)
            .doc("0, 0 takes the tileset's own size.");
        type.field<&TileLayer::layer>("layer").range(-1000.0f, 1000.0f).doc("Higher is in front.");
        type.field<&TileLayer::tint>("tint").doc("Multiplies the tiles' colors.");
    }
};

}  // namespace plumb
