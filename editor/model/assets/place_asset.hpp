#pragma once

#include <string_view>

#include "editor/model/workspace.hpp"
#include "reflect/type_info.hpp"

namespace plumb::editor {

/// True if a file of this kind can be dropped into a scene.
bool canBePlaced(AssetKind kind);

/// Adds an asset to the scene as one undo step and selects the new entity: an image gives an entity with a
/// Sprite, an animation one with an Animator too, a prefab an instance, a tileset an empty tile layer, a
/// sound an entity with Music.
/// @param at  world px: the center of a sprite, the upper left corner of a tile layer
/// @error     files of this kind cannot be placed, a game is running, no scene is open, or the file is
///            invalid
Result<Done> placeAsset(Workspace& workspace, std::string_view path, Vec2 at);

/// Size of an asset's image if it were placed in the scene.
struct PlacedPicture {
    Vec2 size;               ///< size, px; {0, 0}: the asset has none
    Vec2 pivot{0.5f, 0.5f};  ///< the point placed at the mouse, as a ratio of the size
};
PlacedPicture placedPicture(Workspace& workspace, std::string_view path);

/// Returns the grid position for an asset dropped at `at`. An image whose size is a multiple of `step` snaps
/// so that it covers whole cells. Any other image snaps to the nearest grid corner or, if its pivot is on its
/// lower edge, to the lower edge of the cell.
/// @param step  size of a grid cell, px
Vec2 placedOnGrid(Vec2 at, const PlacedPicture& picture, Vec2 step);

}  // namespace plumb::editor
