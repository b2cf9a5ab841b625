#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/file.hpp"
#include "core/result.hpp"
#include "import/tiled_map.hpp"

namespace plumb {

/// Reads a file that a map references; tests pass their own function.
using FileReader = std::function<Result<std::string>(const Path&)>;

/// Reads a Tiled map (TMX or JSON), with the tilesets and templates that it references.
/// Invalid parts are reported in `warnings` and ignored; the rest is read.
///
/// @param file      path of the map; paths in it are relative to its folder
/// @param readFrom  reads the referenced files
/// @error           not a map, of an unknown orientation, or without a tile size
Result<tiled::Map> parseTiledMap(std::string_view text, const Path& file, const FileReader& readFrom,
                                 std::vector<Error>& warnings);

/// Reads a Tiled map from a file, which may be compressed with gzip.
Result<tiled::Map> loadTiledMap(const Path& file, std::vector<Error>& warnings);

}  // namespace plumb
