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

/// Replaces the path of a file, or of all files below a folder, in the strings of a JSON file. All other
/// bytes stay unchanged. Only whole strings match, so "a.png" does not match "data.png".
/// @param times  increased by the number of replacements; may be null
std::string withRenamedAsset(std::string_view json, std::string_view from, std::string_view to, bool folder,
                             int* times = nullptr);

/// Returns the JSON files of a project (scenes, prefabs, tilesets, …) that reference a file, or any file
/// below a folder.
std::vector<AssetUse> usesOfAsset(const Path& root, std::string_view path, bool folder);

}  // namespace plumb::editor
