#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "editor/model/document/tile_stamp.hpp"

namespace plumb::editor {

/// Tiles as JSON text, so that they go to other layers, other scenes, and through the system's clipboard.
std::string tilesAsText(const TileStamp& stamp);
/// Nothing when the text holds no tiles.
std::optional<TileStamp> tilesFromText(std::string_view text);

}  // namespace plumb::editor
