#pragma once

#include <string>
#include <string_view>

namespace plumb {

/// Returns a scene's path in the project for what names it in code, in scripts and on the command line:
/// "level1", "level1.scene.json" and "scenes/level1" are scenes/level1.scene.json; a whole path with a folder
/// is as it is.
std::string scenePath(std::string_view name);

}  // namespace plumb
