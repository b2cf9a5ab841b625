#pragma once

#include <string>
#include <vector>

#include "core/file.hpp"
#include "core/result.hpp"

namespace plumb {

/// A file that an import will put into a project.
struct ImportedFile {
    std::string path;  ///< in the project
    std::string bytes;
};

/// Puts the files of one import into a project: all or none. They are written beside the project's own, in
/// `.plumb/import`, and a list of them says when all are there; only then does each take its place. An import
/// that was killed is undone or finished by `finishImport`.
/// @error  a name that leaves the project, or a place that cannot be written; the project is as it was
Result<Done> commitImport(const Path& root, const std::vector<ImportedFile>& files);

/// Finishes an import that was killed after all its files were there. Before that moment it left nothing
/// behind that a game sees.
void finishImport(const Path& root);

}  // namespace plumb
