#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/project.hpp"
#include "core/file.hpp"
#include "core/result.hpp"

namespace plumb::editor {

/// What an export is made of beside the project.
struct ExportParts {
    Path player;        ///< the program, or for a page the folder with player.js, player.wasm and index.html
    Path engineAssets;  ///< folder of the engine's assets, e.g. fonts
    Path licences;      ///< folder with a text for each library that the player contains; empty: none
};

struct ExportReport {
    std::size_t files = 0;             ///< in the pack
    std::uintmax_t bytes = 0;          ///< of all files of the export
    std::string program;               ///< what starts the game, relative to the folder
    std::vector<std::string> written;  ///< paths of all files of the export in the folder, sorted
    std::vector<std::string> largest;  ///< the five largest files of the pack, "assets/music.ogg, 1.2 MB"
};

/// Exports a project to a folder for distribution:
///
///     NAME, NAME.exe or index.html   starts the game; NAME is fileNameOf(the name of the project)
///     game.pack                      the project and the engine's assets (app/player.hpp), without code,
///                                    hidden files and what project.json leaves out
///     licences.txt                   of the libraries in the program
///     icon.png                       of a page and of NAME, if the project has one
///     NAME.desktop                   starts NAME from a desktop
///
/// All files are written, or after an error none. Those of an earlier export of the same game are replaced;
/// all other files in the folder stay. The same project and player give the same bytes.
/// @error  the folder is inside the project or contains it, has content but no export of this game, or cannot
/// be written; no player; a file of the project that cannot be read or has a name that no pack takes
Result<ExportReport> exportProject(const Project& project, const Path& folder, const ExportParts& parts);

/// Copies an export of the project that exportProject() has written to another folder, in the same way.
Result<Done> placeExport(const Project& project, const Path& finished, const Path& folder);

}  // namespace plumb::editor
