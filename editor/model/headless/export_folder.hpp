#pragma once

#include <string>
#include <vector>

#include "app/project.hpp"
#include "core/file.hpp"
#include "core/result.hpp"

namespace plumb::editor {

/// The folder that an export is written to. It may have other content, which stays as it is.
class ExportFolder {
public:
    /// Checks the folder and changes nothing.
    /// @error the folder is inside the project or contains it; has content, but no export of this game
    static Result<ExportFolder> check(const Project& project, const Path& folder);

    /// An empty folder in it, for the files until all of them are written.
    Result<Path> stage();
    /// Moves the files from stage() to their places, all of them or, after an error, none. Returns their
    /// paths, sorted. Those of an earlier export are replaced.
    /// @error a folder is in the place of a file, or the reverse; a program uses a file
    Result<std::vector<std::string>> place();
    /// Removes what stage() made. If the folder did not exist before and has no files, it is removed too.
    void clear();

private:
    explicit ExportFolder(Path folder) : folder_{std::move(folder)} {}
    [[nodiscard]] Result<Done> checkPlaces(const std::vector<std::string>& files) const;

    Path folder_;
    Path made_;  // the outermost folder that stage() has made; empty: none
};

}  // namespace plumb::editor
