#pragma once

#include "core/file.hpp"
#include "core/result.hpp"
#include "import/import_report.hpp"

namespace plumb {

/// Makes a scene of a project of the LDtk editor: each level below an entity of its own that stands where its
/// world puts it, tile layers, entities with their fields as properties. A project of several worlds becomes
/// a scene for each, the others beside the first: `name-World.scene.json`. Importing again keeps the ids.
///
/// @param scene  ends in ".scene.json"; see importTiled
/// @error        the project cannot be read at all, or nothing can be written
Result<ImportReport> importLdtk(const Path& project, const Path& scene);

}  // namespace plumb
