#pragma once

#include <string>

#include "app/project.hpp"
#include "core/file.hpp"
#include "core/result.hpp"

namespace plumb::editor {

/// Returns the resource script (.rc) with which the program of an exported game gets the project's name and
/// version, and the icon game.ico if the project has an icon.
std::string resourceScript(const Project& project);

/// Writes game.rc and game.ico, for player/targets/prepare.sh.
/// @error  the icon is missing, no picture or not square; the folder cannot be written
Result<Done> writeWindowsResources(const Project& project, const Path& folder);

}  // namespace plumb::editor
