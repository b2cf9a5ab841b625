#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/file.hpp"

namespace plumb::editor {

/// A file that references an asset.
struct AssetUse {
    std::string file;  ///< path in the project
    int times = 0;     ///< number of references
};

/// Replaces the path `from` of a file or (`folder`) the start of all paths below the folder `from` by `to` in
/// the strings of a JSON text. All other bytes stay. Only whole names match: not "a.png" in "data.png".
/// @param times  increased by the number of replacements; may be null
std::string withRenamedAsset(std::string_view json, std::string_view from, std::string_view to, bool folder,
                             int* times = nullptr);

/// Returns the JSON files of a project (scenes, prefabs, tilesets, …) that reference the file `path` or
/// (`folder`) any file below the folder `path`.
std::vector<AssetUse> usesOfAsset(const Path& root, std::string_view path, bool folder);

}  // namespace plumb::editor
