#pragma once

#include "core/file.hpp"
#include "core/result.hpp"
#include "import/import_report.hpp"

namespace plumb {

/// Converts a sprite sheet exported by Aseprite to an animation file: each tag becomes a clip; a sheet
/// without tags becomes one clip of all frames. Frames that were trimmed, rotated or packed are copied to a
/// new sheet with cells of equal size.
///
/// @param sheet      the exported .json file, with frames as a hash or an array
/// @param animation  path of the file to write, ending in ".anim.json", inside a project folder
/// @error            not an Aseprite sheet, its image cannot be read, or the files cannot be written
Result<ImportReport> importAseprite(const Path& sheet, const Path& animation);

}  // namespace plumb
