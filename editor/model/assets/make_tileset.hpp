#pragma once

#include <string>
#include <string_view>

#include "assets/texture.hpp"
#include "assets/tileset.hpp"
#include "editor/model/workspace.hpp"

namespace plumb::editor {

/// Makes a tileset of a picture, beside it, with tiles as large as the cells of the grid: one step of undo.
/// @return the path of the tileset; that of one which is there already, unchanged
/// @error  it is no picture, a game is running, or no tile fits into the picture
Result<std::string> makeTileset(Workspace& workspace, std::string_view picture);

/// How many tiles of the set's size the picture has room for.
TilesetSize roomFor(const Tileset& tileset, const Texture& picture);

/// Divides the set's picture into tiles of another size. What was special about tiles is lost.
/// @param width, height  px, at least 1
/// @param picture        px
void setTileSize(Tileset& tileset, int width, int height, const Texture& picture);

}  // namespace plumb::editor
