#pragma once

#include <string_view>

#include "editor/model/workspace.hpp"
#include "reflect/type_info.hpp"

namespace plumb::editor {

/// Whether a file of this kind can be dropped into a scene.
bool canBePlaced(AssetKind kind);

/// Puts a file into the scene as one step of undo and selects what it made: a picture becomes an entity with
/// a Sprite, an animation one with an Animator too, a prefab an instance, a tileset an empty tile layer ready
/// to be painted, a sound the tune of the scene.
/// @param at  px, world: the middle of a picture, the corner of a tile layer
/// @error     such files cannot be placed, no scene is open, or the file is broken
Result<Done> placeAsset(Workspace& workspace, std::string_view path, Vec2 at);

/// What the file would look like in the scene.
struct PlacedPicture {
    Vec2 size;               ///< px; {0, 0} when it has no size of its own
    Vec2 pivot{0.5f, 0.5f};  ///< ratio of it: where it is put
};
PlacedPicture placedPicture(Workspace& workspace, std::string_view path);

/// Where a file comes to that is let go over a grid: a picture of whole cells to the cells under the mouse.
/// Any other one goes to the nearest crossing, or if it stands on its lower edge to the lower edge of the
/// cell.
/// @param step  px, between two crossings
Vec2 placedOnGrid(Vec2 at, const PlacedPicture& picture, Vec2 step);

}  // namespace plumb::editor
