#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/limits.hpp"
#include "core/result.hpp"

namespace plumb {

using Path = std::filesystem::path;

/// Reads a whole file.
/// @error missing, not a file, larger than `limit`, unreadable
Result<std::string> readFile(const Path& path, std::size_t limit = limits::kFileBytes);

/// Atomic write: a crash, a full disk or a power cut leaves either the old or the new file. Temporary
/// file in the same folder, flush, fsync, rename, fsync of the folder. Creates missing folders.
Result<Done> writeFile(const Path& path, std::string_view bytes);

/// Every path that comes from a file must pass through this function: joins `relative`
/// to `root`, and checks that the result stays inside, also through symbolic links.
/// @error absolute, drive or UNC paths, `..` or links that leave `root`, backslashes, control characters
Result<Path> pathInside(const Path& root, std::string_view relative);

/// Files below `folder` whose names end with `ending`, relative to it with '/', sorted. Follows no links.
std::vector<std::string> filesBelow(const Path& folder, std::string_view ending);

/// Returns a number that changes with the file's time or size; 0 if there is no file. For hot reload.
std::uint64_t fileStamp(const Path& path);

}  // namespace plumb
