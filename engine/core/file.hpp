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

/// The whole file as bytes.
/// @error missing, not a file, larger than `limit`, unreadable
Result<std::string> readFile(const Path& path, std::size_t limit = limits::kFileBytes);

/// Writes so that a crash, a full disk or a power cut leaves the old file or the new one, never a part:
/// temporary file beside it, flush, fsync, rename, fsync of the folder. Creates missing folders.
Result<Done> writeFile(const Path& path, std::string_view bytes);

/// The one door through which names from files become paths: `relative` joined to `root`, with the proof
/// that it stays inside, also through symbolic links.
/// @error absolute, drive or UNC paths, `..` that climbs out, back slashes, control characters, links that leave
Result<Path> pathInside(const Path& root, std::string_view relative);

/// Files below `folder` whose names end so, relative to it with '/', sorted. Links are not followed.
std::vector<std::string> filesBelow(const Path& folder, std::string_view ending);

/// A number that changes when the file does (time and size); 0 when there is none. For hot reload.
std::uint64_t fileStamp(const Path& path);

}  // namespace plumb
