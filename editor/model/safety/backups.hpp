#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/file.hpp"

namespace plumb::editor {

/// The folder beside a project for what the editor needs and no user edits: journals and backups. It tells
/// git to leave it out.
Path makeEditorFolder(const Path& project);

/// A file as it once was.
struct Backup {
    Path path;
    std::string when;  ///< "22 Nov 02:15:03", local time
    std::uintmax_t bytes = 0;
};

/// The last versions of the files of a project, in `.plumb/backups`. Nothing here ever touches the file
/// itself.
class Backups {
public:
    static constexpr std::size_t kCopies = 10;  ///< of each file

    explicit Backups(Path project) : project_{std::move(project)} {}

    /// Keeps the file as it is now; nothing when there is none. Call it before it is written anew.
    /// @param file  its path in the project
    void keep(std::string_view file) const;
    /// Keeps a text that never became the file, so that it can still be had.
    void keepText(std::string_view file, std::string_view text) const;
    /// Of a file, the newest first.
    [[nodiscard]] std::vector<Backup> of(std::string_view file) const;

private:
    [[nodiscard]] Path folderOf(std::string_view file) const;
    [[nodiscard]] Path nextPath(const Path& folder) const;

    Path project_;
};

}  // namespace plumb::editor
