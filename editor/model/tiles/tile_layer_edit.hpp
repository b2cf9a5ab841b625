#pragma once

#include "editor/model/document/tile_paint.hpp"
#include "math/color.hpp"
#include "math/vec2.hpp"

namespace plumb::editor {

class Workspace;

/// The layer drawn before (1) or behind (-1) the one in hand comes to hand.
void selectNextTileLayer(Workspace& workspace, int step);
/// The layer in hand goes before (1) or behind (-1) its neighbour.
void moveTileLayer(Workspace& workspace, int step);
/// How much of the tiles one sees through (ratio, 0..1); where the layer lies (px); how it goes with the
/// camera (ratio; 1 is part of the world).
void setLayerOpacity(Workspace& workspace, ObjectId layer, float opacity);
void setLayerOffset(Workspace& workspace, ObjectId layer, Vec2 offset);
void setLayerParallax(Workspace& workspace, ObjectId layer, Vec2 factor);
void setLayerTint(Workspace& workspace, ObjectId layer, Color tint);
/// As it is seen now: from its ParallaxLayer, or 1.
Vec2 layerParallax(const Workspace& workspace, ObjectId layer);
/// Whether bodies stand on those of its tiles that have a solid shape: by its TileCollider.
bool isSolidLayer(const Workspace& workspace, ObjectId layer);
void setLayerSolid(Workspace& workspace, ObjectId layer, bool solid);
/// An empty layer before the others, as large, with the tileset and as solid as the one in hand; the first
/// one is solid. It comes to hand.
void addTileLayer(Workspace& workspace);
/// Chooses the tiles of the layer's terrain anew.
void retileLayer(Workspace& workspace);

}  // namespace plumb::editor
