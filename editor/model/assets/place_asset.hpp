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

/// How large the file would be in the scene (px); {0, 0} when it has no size of its own.
Vec2 placedSize(Workspace& workspace, std::string_view path);

}  // namespace plumb::editor
