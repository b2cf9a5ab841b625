#pragma once

#include <string_view>
#include <vector>

#include "import/ldtk_project.hpp"
#include "import/loaders/tmx_loader.hpp"

namespace plumb {

/// Reads an LDtk project, including levels stored in separate files.
/// Invalid parts are reported in `warnings` and ignored; the rest is read.
///
/// @param file      path of the project; paths in it are relative to its folder
/// @param readFrom  reads the files of separate levels
/// @error           not JSON, or not an LDtk project
Result<ldtk::Project> parseLdtk(std::string_view text, const Path& file, const FileReader& readFrom,
                                std::vector<Error>& warnings);

/// Reads an LDtk project from a file.
Result<ldtk::Project> loadLdtk(const Path& file, std::vector<Error>& warnings);

}  // namespace plumb
