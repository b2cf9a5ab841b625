#pragma once

#include <cstdint>

#include "core/file.hpp"
#include "core/result.hpp"

namespace plumb::editor {

/// What an export takes along besides the project.
struct ExportParts {
    Path player;        ///< the program that plays; empty or missing: the folder gets none
    Path engineAssets;  ///< fonts and the like
};

struct ExportReport {
    std::size_t files = 0;
    std::uintmax_t bytes = 0;
    bool runnable = false;  ///< with a player and a script that starts it
};

/// Copies a project into a folder that can be given to others:
///
///     FOLDER/play            starts the game
///     FOLDER/plumb-player    plays FOLDER/game
///     FOLDER/assets/         the engine's own
///     FOLDER/game/           the project, without hidden files: no journal, no backups
///
/// The folder is there as a whole or not at all; an earlier export in it is replaced.
/// @error  the folder is inside the project, or holds other things, or cannot be written
Result<ExportReport> exportProject(const Path& project, const Path& folder, const ExportParts& parts);

}  // namespace plumb::editor
