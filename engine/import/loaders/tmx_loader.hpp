#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/file.hpp"
#include "core/result.hpp"
#include "import/tiled_map.hpp"

namespace plumb {

/// How the files that a map names are read; tests give their own.
using FileReader = std::function<Result<std::string>(const Path&)>;

/// Reads a map of the Tiled editor (TMX or JSON), with the tilesets and templates that it names.
/// What is wrong inside is listed in `warnings` and left out; the rest is read.
///
/// @param file  where the map lies: names in it are relative to its folder
/// @error       no map at all, one of another form than orthogonal, or past a limit
Result<tiled::Map> parseTiledMap(std::string_view text, const Path& file, const FileReader& readFrom,
                                 std::vector<Error>& warnings);

/// The same for a file, which may be packed with gzip.
Result<tiled::Map> loadTiledMap(const Path& file, std::vector<Error>& warnings);

}  // namespace plumb
