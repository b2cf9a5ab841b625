#pragma once

#include <string>
#include <string_view>

#include "core/file.hpp"

namespace plumb {

/// The folder of the running program; the current folder if that is unknown.
Path executableFolder();

/// The engine's own assets (fonts, icons), which `engine:` in an asset
/// path refers to. The first that exists of: PLUMB_ASSETS, assets/
/// beside the program (an exported game), assets/ of the source tree.
const Path& engineAssets();

/// The folder that contains assets/ of a game without project.json: the program's
/// folder, the project's folder in the source tree, or else the current folder.
/// @param program  name of the program, equal to that of the project's folder
Path codeGameFolder(const Path& program);

/// The name of a game as that of a file: without characters that some system does not allow there, and with a
/// '_' if it is the name of a device of Windows, e.g. "Con".
std::string fileNameOf(std::string_view game);

/// The folder for what a game keeps on this computer: saved games, settings of the player, reports of
/// crashes; created if missing. `$XDG_DATA_HOME/NAME` on Linux, `%APPDATA%/NAME` on Windows.
/// @param game  its name; that of the folder is fileNameOf(game)
/// @error the system has no such folder (neither HOME nor an absolute XDG_DATA_HOME is set), or it cannot be
/// created
Result<Path> dataFolder(std::string_view game);

}  // namespace plumb
