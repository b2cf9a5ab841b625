#pragma once

#include "core/file.hpp"

namespace plumb {

/// The folder that holds the running program; the current one when the system does not say.
Path executableFolder();

/// The engine's own assets (fonts, icons): what `engine:` in an asset's path stands for. The first that
/// exists of PLUMB_ASSETS, assets/ beside the program (an exported game), assets/ of the tree it was built
/// in.
const Path& engineAssets();

/// The folder of a game in code, which holds its assets/: the program's own, that of the project in the tree
/// it was built in, else the current one.
/// @param program  its name, as its project's folder is called
Path codeGameFolder(const Path& program);

/// Where the person's settings belong; made when missing. `$XDG_DATA_HOME/plumb` on Linux.
Path settingsFolder();

}  // namespace plumb
