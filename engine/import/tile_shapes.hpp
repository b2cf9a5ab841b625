#pragma once

#include <string>
#include <string_view>
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

/// A collision shape that is left out or changed, and why.
struct ShapeRefusal {
    const tiled::Object* shape = nullptr;
    std::string what;
};

/// Returns the collision shapes of a tile, without those that have neither area nor length or more than
/// kMaxOutlineCorners corners.
/// @param imageHeight  of the tile, px; shapes in an isometric grid are drawn from its lower edge
/// @param refusals     if not null, the shapes that are left out are added to it
std::vector<CollisionLine> collisionLinesOf(const tiled::Tile& tile, const tiled::Tileset& tileset,
                                            float imageHeight, std::vector<ShapeRefusal>* refusals = nullptr);

/// The part of a cell that the collision shapes of a tile fill.
struct TileArea {
    std::vector<std::vector<Vec2>> polygons;  ///< px in the cell; they may be concave and overlap
    std::vector<ShapeRefusal> refusals;       ///< shapes that were left out or clipped to the cell
};

/// Converts the collision shapes of a tile to polygons. Lines become thin areas, 1/32 of a cell thick.
/// @param raised  px from the cell's top down to the top of the tile's image; negative if the image is higher
TileArea areaOfTile(const tiled::Tile& tile, Vec2 cell, float raised);

/// Returns the name of a kind of shapes, for reports.
std::string_view nameOf(tiled::Shape shape);

}  // namespace plumb
