#pragma once

#include <string>
#include <vector>

#include "core/file.hpp"
#include "core/result.hpp"

namespace plumb {

/// What an import brought in, and what it could not.
struct ImportReport {
    std::string scene;  ///< path of the scene in its project
    int layers = 0;
    int tiles = 0;  ///< cells that are not empty
    int objects = 0;
    int tilesets = 0;
    int images = 0;
    std::vector<std::string> files;  ///< written, as paths in the project; the scene is the last
    std::vector<Error> problems;

    /// For people: one line of counts, then one line for each problem.
    [[nodiscard]] std::string text() const;
};

/// Makes a scene of a map of the Tiled editor, with tilesets and copies of its images below
/// `assets/<name of the scene>/`. All files are written whole or not at all, the scene last; importing again
/// replaces them and keeps the ids of the entities.
///
/// @param map    a .tmx or .tmj file, packed with gzip or not
/// @param scene  ends in ".scene.json" and lies in a project: its folder or one around it holds project.json;
///               without one, the folder around `scenes` counts as the project
/// @error        the map cannot be read at all, or nothing can be written
Result<ImportReport> importTiled(const Path& map, const Path& scene);

}  // namespace plumb
