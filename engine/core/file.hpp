#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/limits.hpp"
#include "core/result.hpp"

namespace plumb {

using Path = std::filesystem::path;

/// Files that are not on the disk, e.g. those of a pack.
class FileSource {
public:
    virtual ~FileSource() = default;
    /// The paths of all files, relative, with '/', sorted.
    [[nodiscard]] virtual std::span<const std::string> paths() const = 0;
    /// @param index  of a path in paths()
    [[nodiscard]] virtual Result<std::string> read(std::size_t index) const = 0;
};

/// Which file is read if one of the same path is on the disk, too.
enum class Preferred : unsigned char { OnDisk, Mounted };

/// Adds the files of a source to a folder for all functions below. Replaces what was mounted at the folder;
/// null: removes it. Not while other threads read files.
void mountFiles(const Path& folder, std::shared_ptr<const FileSource> source,
                Preferred preferred = Preferred::OnDisk);

/// True if there is a regular file, on the disk or mounted.
bool fileExists(const Path& path);
/// True if there is a folder on the disk, or one that contains mounted files.
bool folderExists(const Path& path);

/// Reads a whole file.
/// @error missing, not a file, larger than `limit`, unreadable
Result<std::string> readFile(const Path& path, std::size_t limit = limits::kFileBytes);

/// Atomic write: a crash, a full disk or a power cut leaves either the old or the new file. Temporary
/// file in the same folder, flush, fsync, rename, fsync of the folder. Creates missing folders.
Result<Done> writeFile(const Path& path, std::string_view bytes);

/// Returns why a name that comes from a file must not become a path below a folder; empty if it may. Looks at
/// the characters only.
std::string whyPathRefused(std::string_view relative);

/// Every path that comes from a file must pass through this function: joins `relative`
/// to `root`, and checks that the result stays inside, also through symbolic links.
/// @error absolute, drive or UNC paths, `..` or links that leave `root`, backslashes, control characters
Result<Path> pathInside(const Path& root, std::string_view relative);

/// Files below `folder` whose names end with `ending`, relative to it with '/', sorted. Follows no links.
std::vector<std::string> filesBelow(const Path& folder, std::string_view ending);

/// Returns a number that changes with the file's time or size; 0 if there is no file. For hot reload.
std::uint64_t fileStamp(const Path& path);

}  // namespace plumb
