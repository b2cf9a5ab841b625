#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/file.hpp"

namespace plumb::editor {

/// A file that names another one.
struct AssetUse {
    std::string file;  ///< path in the project
    int times = 0;
};

/// Exchanges the path of a file, or of all files below a folder, in the texts of a JSON file. Everything else
/// stays byte for byte. Texts are compared as a whole, so that "a.png" is no part of "data.png".
/// @param times  how often; may be null
std::string withRenamedAsset(std::string_view json, std::string_view from, std::string_view to, bool folder,
                             int* times = nullptr);

/// The scenes, prefabs, tilesets, animations and the like of a project that name a file, or one below a
/// folder.
std::vector<AssetUse> usesOfAsset(const Path& root, std::string_view path, bool folder);

}  // namespace plumb::editor
