#pragma once

#include "core/file.hpp"
#include "core/result.hpp"
#include "import/import_report.hpp"

namespace plumb {

/// Makes a scene of a map of the Tiled editor, with tilesets and copies of its images below
/// `assets/<name of the scene>/`. All files are written whole or not at all, the scene last; importing again
/// replaces them and keeps the ids of the entities.
///
/// @param map    a .tmx or .tmj file, packed with gzip or not
/// @param scene  ends in ".scene.json" and lies in a project: its folder or one around it holds project.json;
///               without one, the folder around `scenes` counts as the project
/// @error        the map cannot be read at all, or nothing can be written
Result<ImportReport> importTiled(const Path& map, const Path& scene);

/// The same for a .world: its maps become one scene, each below an entity of its own that stands where the
/// world puts it. A map that cannot be read is reported, and the others come in.
Result<ImportReport> importTiledWorld(const Path& world, const Path& scene);

}  // namespace plumb
