#pragma once

#include "editor/model/document/tile_paint.hpp"
#include "math/color.hpp"
#include "math/vec2.hpp"

namespace plumb::editor {

class Workspace;

/// Activates the layer drawn in front of (1) or behind (-1) the active one.
void selectNextTileLayer(Workspace& workspace, int step);
/// Swaps the drawing order of the active layer and the next one in front of (1) or behind (-1) it.
void moveTileLayer(Workspace& workspace, int step);
/// Sets the layer's opacity. @param opacity  0 (invisible) to 1 (opaque)
void setLayerOpacity(Workspace& workspace, ObjectId layer, float opacity);
/// Sets the position of the layer's Transform, px.
void setLayerOffset(Workspace& workspace, ObjectId layer, Vec2 offset);
/// Sets the layer's scroll ratio. @param factor  0 stays fixed on the screen, 1 moves like the world
void setLayerParallax(Workspace& workspace, ObjectId layer, Vec2 factor);
void setLayerTint(Workspace& workspace, ObjectId layer, Color tint);
/// Returns the scroll ratio of the layer's ParallaxLayer; 1 if it has none.
Vec2 layerParallax(const Workspace& workspace, ObjectId layer);
/// True if the layer has a TileCollider, so that bodies collide with its tiles that have a shape.
bool isSolidLayer(const Workspace& workspace, ObjectId layer);
/// Adds or removes the layer's TileCollider.
void setLayerSolid(Workspace& workspace, ObjectId layer, bool solid);
/// Adds an empty layer in front of all others and activates it. Its size, tileset and solidity are those of
/// the active layer; the first layer is solid.
void addTileLayer(Workspace& workspace);
/// Replaces the tiles of the active layer's terrain by their autotiled ones, also those painted over by the
/// user.
void retileLayer(Workspace& workspace);

}  // namespace plumb::editor
