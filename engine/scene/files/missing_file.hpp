#pragma once

#include <string_view>

#include "core/file.hpp"
#include "core/result.hpp"

namespace plumb {

/// Returns the error of a file that does not exist, with the name of one that is called similarly.
/// Cost: searches the whole folder.
/// @param root    the project's folder
/// @param path    of the missing file, below `root`
/// @param ending  of the names of such files, e.g. ".scene.json"
Error missingFile(const Path& root, std::string_view path, std::string_view ending);

}  // namespace plumb
