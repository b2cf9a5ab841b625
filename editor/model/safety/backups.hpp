#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/file.hpp"

namespace plumb::editor {

/// Returns the project's folder for data of the editor, such as journals and backups. Creates the folder with
/// a .gitignore that excludes all of it.
Path makeEditorFolder(const Path& project);

/// An earlier version of a file.
struct Backup {
    Path path;         ///< file of the backup
    std::string when;  ///< local time, e.g. "22 Nov 02:15:03"
    std::uintmax_t bytes = 0;
};

/// The last versions of the files of a project, stored in `.plumb/backups`. The original files are never
/// changed.
class Backups {
public:
    static constexpr std::size_t kCopies = 10;  ///< maximum number of backups per file

    explicit Backups(Path project) : project_{std::move(project)} {}

    /// Backs up the present content of a file, if it exists; to be called before the file is overwritten.
    /// @param file  path relative to the project
    void keep(std::string_view file) const;
    /// Stores a text that was never written to the file as one of its backups.
    void keepText(std::string_view file, std::string_view text) const;
    /// Returns the backups of a file, newest first.
    [[nodiscard]] std::vector<Backup> of(std::string_view file) const;

private:
    [[nodiscard]] Path folderOf(std::string_view file) const;
    [[nodiscard]] Path nextPath(const Path& folder) const;

    Path project_;
};

}  // namespace plumb::editor
