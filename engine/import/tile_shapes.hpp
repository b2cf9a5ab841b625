#pragma once

#include <optional>
#include <vector>

#include "import/tiled_map.hpp"
#include "math/vec2.hpp"

namespace plumb {

/// Maximum number of corners of a collider outline.
inline constexpr std::size_t kMaxOutlineCorners = 64;

/// Returns the outline of an object, px from its position, without its rotation; empty if it has no area.
std::vector<Vec2> outlineOf(const tiled::Object& object);

/// A collision shape of a tile, px from the upper left corner of its image.
struct CollisionLine {
    std::vector<Vec2> points;
    bool closed = true;  ///< the outline of an area; otherwise a line that is solid from both sides
};

/// Returns the collision shapes of a tile, without those that have neither area nor length or more than
/// kMaxOutlineCorners corners.
/// @param imageHeight  of the tile, px; shapes in an isometric grid are drawn from its lower edge
std::vector<CollisionLine> collisionLinesOf(const tiled::Tile& tile, const tiled::Tileset& tileset,
                                            float imageHeight);

/// Collision outline made from the collision shapes of a tile.
struct TileOutline {
    std::vector<Vec2> corners;  ///< px in the cell, clockwise on screen; empty if no shape has an area in it
    bool cut = false;           ///< at least one shape was clipped to the cell
    bool partial = false;       ///< the outline is only the largest of several shapes
};

/// Combines the collision shapes of a tile to one outline: the union of boxes if it is one area without
/// holes, otherwise the largest shape.
/// @param raised  px from the cell's top down to the top of the tile's image; negative if the image is higher
TileOutline outlineOfTile(const tiled::Tile& tile, Vec2 cell, float raised);

}  // namespace plumb
