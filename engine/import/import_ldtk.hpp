#pragma once

#include "core/file.hpp"
#include "core/result.hpp"
#include "import/import_report.hpp"

namespace plumb {

/// Converts an LDtk project to a scene with tile layers and entities, whose fields become properties. Each
/// level is an entity at its position in the world; its content is below it. A project of several worlds
/// becomes several scenes in one folder: `name-World.scene.json`. Importing again keeps the entity ids.
///
/// @param scene  path of the file to write, ending in ".scene.json", inside a project folder
/// @error        the project cannot be read, or the files cannot be written
Result<ImportReport> importLdtk(const Path& project, const Path& scene);

}  // namespace plumb
