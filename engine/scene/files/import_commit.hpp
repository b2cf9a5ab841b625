#pragma once

#include <string>
#include <vector>

#include "core/file.hpp"
#include "core/result.hpp"

namespace plumb {

/// A file that an import adds to a project.
struct ImportedFile {
    std::string path;  ///< path in the project
    std::string bytes;
};

/// Adds the files of an import to a project, all or none. They are first written to `.plumb/import`, then a
/// list file marks them complete, then each is moved to its path. finishImport() finishes or discards an
/// import whose process was killed.
/// @error  a path outside the project, or one that cannot be written; the project is unchanged
Result<Done> commitImport(const Path& root, const std::vector<ImportedFile>& files);

/// Finishes an import whose process was killed after the list file was written. One that was killed earlier
/// has not changed any file of the game.
void finishImport(const Path& root);

}  // namespace plumb
