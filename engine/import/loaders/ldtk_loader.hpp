#pragma once

#include <string_view>
#include <vector>

#include "import/ldtk_project.hpp"
#include "import/loaders/tmx_loader.hpp"

namespace plumb {

/// Reads a project of the LDtk editor, with the levels that it keeps in files of their own.
/// What is wrong inside is listed in `warnings` and left out; the rest is read.
///
/// @param file  where the project lies: names in it are relative to its folder
/// @error       no project of LDtk at all, or past a limit
Result<ldtk::Project> parseLdtk(std::string_view text, const Path& file, const FileReader& readFrom,
                                std::vector<Error>& warnings);

/// The same for a file.
Result<ldtk::Project> loadLdtk(const Path& file, std::vector<Error>& warnings);

}  // namespace plumb
