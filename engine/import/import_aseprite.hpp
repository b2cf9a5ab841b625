#pragma once

#include "core/file.hpp"
#include "core/result.hpp"
#include "import/import_report.hpp"

namespace plumb {

/// Makes an animation file of a sprite sheet that Aseprite exported: each tag becomes a clip, a sheet without
/// tags one clip of all frames. Frames that were trimmed, turned or packed are laid out in a new sheet of
/// equal cells.
///
/// @param sheet      the .json of the export, hash or array
/// @param animation  ends in ".anim.json"; see importTiled
/// @error            no sheet of Aseprite, its picture cannot be read, or nothing can be written
Result<ImportReport> importAseprite(const Path& sheet, const Path& animation);

}  // namespace plumb
