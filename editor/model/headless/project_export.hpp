#pragma once

#include <cstdint>

#include "core/file.hpp"
#include "core/result.hpp"

namespace plumb::editor {

/// Files that an export adds to the project.
struct ExportParts {
    Path player;        ///< player executable; empty or missing: the export contains none
    Path engineAssets;  ///< folder of the engine's assets, e.g. fonts
};

struct ExportReport {
    std::size_t files = 0;
    std::uintmax_t bytes = 0;
    bool runnable = false;  ///< the export contains a player and a script that starts it
};

/// Exports a project to a folder for distribution:
///
///     FOLDER/play            starts the game
///     FOLDER/plumb-player    plays FOLDER/game
///     FOLDER/assets/         the engine's assets, without those for making games
///     FOLDER/game/           the project, without hidden files: no journal, no backups
///
/// The folder is created completely or not at all. An earlier export in it is replaced.
/// @error  the folder is inside the project or contains it, has other content, or cannot be written
Result<ExportReport> exportProject(const Path& project, const Path& folder, const ExportParts& parts);

}  // namespace plumb::editor
