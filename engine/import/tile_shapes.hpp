#pragma once

#include <optional>
#include <vector>

#include "import/tiled_map.hpp"
#include "math/vec2.hpp"

namespace plumb {

/// Corners that an outline of the engine may have.
inline constexpr std::size_t kMaxOutlineCorners = 64;

/// The outline of an area in px from its object's position, not turned; empty when it has none.
std::vector<Vec2> outlineOf(const tiled::Object& object);

/// What the shapes of a tile collide as.
struct TileOutline {
    std::vector<Vec2> corners;  ///< px in the cell, clockwise on screen; empty when no shape is an area in it
    bool cut = false;           ///< something reached out of the cell
    bool partial = false;       ///< only the largest of several shapes
};

/// One outline of all shapes of a tile. Boxes that form one area become that area; of other shapes the
/// largest one is taken.
/// @param raised  px by which the tile's picture begins below the cell's top; less than 0 for a higher one
TileOutline outlineOfTile(const tiled::Tile& tile, Vec2 cell, float raised);

}  // namespace plumb
