#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "editor/model/document/tile_stamp.hpp"

namespace plumb::editor {

/// Returns tiles as JSON text, for copying through the system's clipboard.
std::string tilesAsText(const TileStamp& stamp);
/// Parses the text of `tilesAsText`. @return nothing if the text contains no tiles
std::optional<TileStamp> tilesFromText(std::string_view text);

}  // namespace plumb::editor
