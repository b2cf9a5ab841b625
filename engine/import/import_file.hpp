#pragma once

#include <string>

#include "core/file.hpp"
#include "core/result.hpp"
#include "import/import_report.hpp"

namespace plumb {

enum class ImportKind : unsigned char { None, TiledMap, TiledWorld, Ldtk, Aseprite };

/// What kind of foreign file this is, by its ending, and where that says nothing, as for .json, by what is in
/// it. None when it cannot be imported.
ImportKind importKindOf(const Path& file);

/// Whether a file of this name may be one to import; nothing is read.
bool mayBeImported(const Path& file);

/// Where an import of this file goes in a project by default: scenes/NAME.scene.json, or for an
/// animation assets/NAME.anim.json.
Path importTarget(const Path& file, ImportKind kind, const Path& project);

/// Imports a file of whatever kind it is.
/// @param target  empty for `importTarget`
/// @error         unknown kind, unreadable, or nothing can be written
Result<ImportReport> importFile(const Path& file, const Path& target, const Path& project);

}  // namespace plumb
