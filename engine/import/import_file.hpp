#pragma once

#include <string>

#include "core/file.hpp"
#include "core/result.hpp"
#include "import/import_report.hpp"

namespace plumb {

enum class ImportKind : unsigned char { None, TiledMap, TiledWorld, Ldtk, Aseprite };

/// Determines the kind of a file to import by its extension, or by its content if the extension is .json.
/// Returns ImportKind::None if the file cannot be imported.
ImportKind importKindOf(const Path& file);

/// True if a file may be importable, judged by its name only; the file is not read.
bool mayBeImported(const Path& file);

/// Returns the default path of the imported file in a project: scenes/NAME.scene.json, or for an animation
/// assets/NAME.anim.json.
Path importTarget(const Path& file, ImportKind kind, const Path& project);

/// Imports a file of any supported kind.
/// @param target  path of the file to write; empty: importTarget() in the project folder `project`
/// @error         unknown kind, the file cannot be read, or the result cannot be written
Result<ImportReport> importFile(const Path& file, const Path& target, const Path& project);

}  // namespace plumb
