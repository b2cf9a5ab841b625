#pragma once

#include "core/file.hpp"
#include "core/result.hpp"
#include "import/import_report.hpp"

namespace plumb {

/// Converts a Tiled map to a scene, with tilesets and copies of its images below
/// `assets/<name of the scene>/`. Either all files are written, the scene last, or none; importing again
/// replaces them and keeps the entity ids.
///
/// @param map    a .tmx or .tmj file, with or without gzip compression
/// @param scene  path of the file to write, ending in ".scene.json". Its project is the nearest folder above
///               it with a project.json; without one, the parent folder of `scenes`
/// @error        the map cannot be read, or the files cannot be written
Result<ImportReport> importTiled(const Path& map, const Path& scene);

/// Converts a Tiled .world file to one scene. Each map is an entity at the map's position in the world; its
/// content is below it. Maps that cannot be read are reported; the others are imported.
Result<ImportReport> importTiledWorld(const Path& world, const Path& scene);

}  // namespace plumb
