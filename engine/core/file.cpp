#include "core/file.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <system_error>

#include "core/hash.hpp"
#include "core/text.hpp"

#ifdef _WIN32
#include <io.h>
#else
#include <fcntl.h>
#include <unistd.h>
#endif

namespace plumb {
namespace {

namespace fs = std::filesystem;

using FileHandle = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

FileHandle openFile(const Path& path, const char* mode) {
    return {std::fopen(path.string().c_str(), mode), &std::fclose};
}

Error systemError(const Path& path, std::string what, std::string remedy) {
    return {path.generic_string(), std::move(what) + ": " + std::strerror(errno), std::move(remedy)};
}

bool flushToDisk(std::FILE* file) {
    if (std::fflush(file) != 0) return false;
#ifdef _WIN32
    return _commit(_fileno(file)) == 0;
#else
    return ::fsync(::fileno(file)) == 0;
#endif
}

/// Makes the rename durable. Best effort: some file systems do not support it.
void flushFolder([[maybe_unused]] const Path& folder) {
#ifndef _WIN32
    const int handle = ::open(folder.string().c_str(), O_RDONLY);
    if (handle >= 0) {
        ::fsync(handle);
        ::close(handle);
    }
#endif
}

/// Returns why a name from a file must not become a path; empty if it may.
std::string whyRefused(std::string_view relative) {
    if (relative.empty()) return "is empty";
    if (relative.size() > 1024) return "is longer than 1024 characters";
    if (!isUtf8(relative)) return "is not UTF-8";
    if (relative.front() == '/') return "is absolute";
    for (const char c : relative) {
        if (static_cast<unsigned char>(c) < 32 || c == 127) return "contains a control character";
        if (c == '\\') return "contains a backslash";
        if (c == ':') return "contains a colon";
    }
    for (const std::string_view part : split(relative, '/')) {
        if (part == "..") return "contains \"..\"";
    }
    return {};
}

bool isBelow(const Path& root, const Path& path) {
    const auto [rootEnd, pathAt] = std::mismatch(root.begin(), root.end(), path.begin(), path.end());
    return rootEnd == root.end() || (std::next(rootEnd) == root.end() && rootEnd->empty());
}

}  // namespace

Result<std::string> readFile(const Path& path, std::size_t limit) {
    std::error_code failed;
    if (!fs::exists(path, failed)) {
        return Error{path.generic_string(), "there is no such file", "check the name, or put the file there"};
    }
    if (!fs::is_regular_file(path, failed)) {
        return Error{path.generic_string(), "the path is not a regular file", "write the path of a file"};
    }
    const std::uintmax_t size = fs::file_size(path, failed);
    if (failed || size > limit) {
        return Error{path.generic_string(), format("the file has {} bytes, the limit is {}", size, limit),
                     "split it or make it smaller"};
    }
    const FileHandle file = openFile(path, "rb");
    if (!file) return systemError(path, "could not be opened", "check its permissions");
    std::string bytes(static_cast<std::size_t>(size), '\0');
    const std::size_t count = std::fread(bytes.data(), 1, bytes.size(), file.get());
    if (std::ferror(file.get()) != 0) return systemError(path, "could not be read", "check the disk");
    bytes.resize(count);
    return bytes;
}

Result<Done> writeFile(const Path& path, std::string_view bytes) {
    std::error_code failed;
    if (path.has_parent_path()) fs::create_directories(path.parent_path(), failed);
    Path temporary = path;
    temporary += ".tmp~";
    {
        FileHandle file = openFile(temporary, "wb");
        if (!file) {
            return systemError(path, "could not be written", "check the folder's permissions and the disk");
        }
        const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file.get()) == bytes.size();
        if (!written || !flushToDisk(file.get()) || std::fclose(file.release()) != 0) {
            Error error =
                systemError(path, "could not be written", "free some space; the old file is untouched");
            fs::remove(temporary, failed);
            return error;
        }
    }
    fs::rename(temporary, path, failed);
    if (failed) {
        const std::string why = failed.message();
        fs::remove(temporary, failed);
        return Error{path.generic_string(), "could not be replaced: " + why, "check its permissions"};
    }
    flushFolder(path.has_parent_path() ? path.parent_path() : Path{"."});
    return Done{};
}

Result<Path> pathInside(const Path& root, std::string_view relative) {
    const auto refuse = [&](std::string why) {
        return Error{std::string{relative.substr(0, 200)}, "the path " + std::move(why),
                     "write a path inside the project, with '/', e.g. assets/player.png"};
    };
    if (std::string why = whyRefused(relative); !why.empty()) return refuse(std::move(why));
    std::error_code failed;
    const Path realRoot = fs::weakly_canonical(root, failed);
    if (failed) return refuse("has a root that cannot be resolved");
    const Path real = fs::weakly_canonical(realRoot / Path{relative}, failed);
    if (failed || !isBelow(realRoot, real)) return refuse("leaves the project through a symbolic link");
    return realRoot / Path{relative};
}

std::vector<std::string> filesBelow(const Path& folder, std::string_view ending) {
    std::vector<std::string> files;
    std::error_code failed;
    for (fs::recursive_directory_iterator at{folder, failed}, end; !failed && at != end;
         at.increment(failed)) {
        if (at->is_regular_file(failed) && endsWith(at->path().filename().string(), ending)) {
            files.push_back(at->path().lexically_relative(folder).generic_string());
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

std::uint64_t fileStamp(const Path& path) {
    std::error_code failed;
    const auto time = fs::last_write_time(path, failed);
    if (failed) return 0;
    const std::uintmax_t size = fs::file_size(path, failed);
    const auto ticks = static_cast<std::uint64_t>(time.time_since_epoch().count());
    return mixBits(ticks ^ mixBits(failed ? 0 : size)) | 1;
}

}  // namespace plumb
