#pragma once

#include <string>
#include <string_view>

#include "assets/texture.hpp"
#include "assets/tileset.hpp"
#include "editor/model/workspace.hpp"

namespace plumb::editor {

/// Creates a tileset file beside an image, with tiles of the size of the editor's grid, as one undo step.
/// @return the path of the tileset; if the file already exists, it is left unchanged
/// @error  the file is not an image, a game is running, or no tile fits into the image
Result<std::string> makeTileset(Workspace& workspace, std::string_view picture);

/// Returns the number of columns and rows of tiles that fit into the image.
TilesetSize roomFor(const Tileset& tileset, const Texture& picture);

/// Divides a tileset's image into tiles of another size. Properties of tiles and terrains are dropped.
/// @param width, height  tile size, px, at least 1
/// @param picture        the tileset's image
void setTileSize(Tileset& tileset, int width, int height, const Texture& picture);

}  // namespace plumb::editor
