#include "core/file.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <optional>
#include <system_error>
#include <utility>

#include "core/hash.hpp"
#include "core/os.hpp"
#include "core/text.hpp"

namespace plumb {
namespace {

namespace fs = std::filesystem;

using FileHandle = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

FileHandle openFile(const Path& path, const char* mode) { return {os::openFile(path, mode), &std::fclose}; }

Error systemError(const Path& path, std::string what, std::string remedy) {
    return {path.generic_string(), std::move(what) + ": " + std::strerror(errno), std::move(remedy)};
}

bool isBelow(const Path& root, const Path& path) {
    const auto [rootEnd, pathAt] = std::mismatch(root.begin(), root.end(), path.begin(), path.end());
    return rootEnd == root.end() || (std::next(rootEnd) == root.end() && rootEnd->empty());
}

/// What mountFiles() has added.
struct Mount {
    Path folder;  // absolute
    std::shared_ptr<const FileSource> source;
    Preferred preferred = Preferred::OnDisk;
};

std::vector<Mount>& mounts() {
    static std::vector<Mount> all;
    return all;
}

Path absoluteOf(const Path& path) {
    std::error_code failed;
    Path whole = fs::absolute(path, failed).lexically_normal();
    return whole.has_filename() ? whole : whole.parent_path();
}

/// The path of a file or folder within a mounted source; empty for the folder of the source itself.
std::optional<std::string> pathWithin(const Mount& mount, const Path& absolute) {
    if (absolute == mount.folder) return std::string{};
    if (!isBelow(mount.folder, absolute)) return std::nullopt;
    return absolute.lexically_relative(mount.folder).generic_string();
}

struct MountedFile {
    const FileSource* source = nullptr;
    std::size_t index = 0;
    Preferred preferred = Preferred::OnDisk;
};

std::optional<MountedFile> findMounted(const Path& path) {
    if (mounts().empty()) return std::nullopt;
    const Path absolute = absoluteOf(path);
    for (const Mount& mount : mounts()) {
        const std::optional<std::string> within = pathWithin(mount, absolute);
        if (!within) continue;
        const std::span<const std::string> paths = mount.source->paths();
        const auto at = std::lower_bound(paths.begin(), paths.end(), *within);
        if (at != paths.end() && *at == *within)
            return MountedFile{mount.source.get(), static_cast<std::size_t>(at - paths.begin()),
                               mount.preferred};
    }
    return std::nullopt;
}

Error tooLarge(const Path& path, std::uintmax_t size, std::size_t limit) {
    return {path.generic_string(), format("the file has {} bytes, the limit is {}", size, limit),
            "split it or make it smaller"};
}

Result<std::string> readMounted(const MountedFile& file, const Path& path, std::size_t limit) {
    Result<std::string> bytes = file.source->read(file.index);
    if (bytes && bytes->size() > limit) return tooLarge(path, bytes->size(), limit);
    return bytes;
}

/// True if the files on the disk count for nothing at this path: it lies in a folder of a source that is
/// preferred.
bool isHidden(const Path& path) {
    if (mounts().empty()) return false;
    const Path absolute = absoluteOf(path);
    return std::any_of(mounts().begin(), mounts().end(), [&](const Mount& mount) {
        const std::optional<std::string> within = pathWithin(mount, absolute);
        if (mount.preferred != Preferred::Mounted || !within || within->empty()) return false;
        const std::string top = within->substr(0, within->find('/')) + '/';
        const std::span<const std::string> paths = mount.source->paths();
        const auto at = std::lower_bound(paths.begin(), paths.end(), top);
        return at != paths.end() && startsWith(*at, top);
    });
}

/// The mounted files in a folder, as the part of their path after the folder.
std::vector<std::string> mountedBelow(const Path& folder) {
    std::vector<std::string> files;
    if (mounts().empty()) return files;
    const Path absolute = absoluteOf(folder);
    for (const Mount& mount : mounts()) {
        std::optional<std::string> start = pathWithin(mount, absolute);
        if (!start) continue;
        if (!start->empty()) *start += '/';
        const std::span<const std::string> paths = mount.source->paths();
        for (auto at = std::lower_bound(paths.begin(), paths.end(), *start);
             at != paths.end() && startsWith(*at, *start); ++at)
            files.push_back(at->substr(start->size()));
    }
    return files;
}

}  // namespace

void mountFiles(const Path& folder, std::shared_ptr<const FileSource> source, Preferred preferred) {
    const Path absolute = absoluteOf(folder);
    std::erase_if(mounts(), [&](const Mount& mount) { return mount.folder == absolute; });
    if (source != nullptr) mounts().push_back({absolute, std::move(source), preferred});
}

bool fileExists(const Path& path) {
    std::error_code failed;
    return (!isHidden(path) && fs::is_regular_file(path, failed)) || findMounted(path).has_value();
}

bool folderExists(const Path& path) {
    std::error_code failed;
    return (!isHidden(path) && fs::is_directory(path, failed)) || !mountedBelow(path).empty();
}

Result<std::string> readFile(const Path& path, std::size_t limit) {
    std::error_code failed;
    const bool onDisk = !isHidden(path) && fs::exists(path, failed);
    if (const std::optional<MountedFile> mounted = findMounted(path);
        mounted && (!onDisk || mounted->preferred == Preferred::Mounted))
        return readMounted(*mounted, path, limit);
    if (!onDisk) {
        return Error{path.generic_string(), "there is no such file", "check the name, or put the file there"};
    }
    if (!fs::is_regular_file(path, failed)) {
        return Error{path.generic_string(), "the path is not a regular file", "write the path of a file"};
    }
    const std::uintmax_t size = fs::file_size(path, failed);
    if (failed || size > limit) {
        return tooLarge(path, size, limit);
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
            constexpr const char* kRemedy = "check the folder's permissions and the disk";
            if (!failed) return systemError(path, "could not be written", kRemedy);
            return Error{path.generic_string(),
                         "could not be written, as its folder could not be created: " + failed.message(),
                         kRemedy};
        }
        const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file.get()) == bytes.size();
        if (!written || !os::flushToDisk(file.get()) || std::fclose(file.release()) != 0) {
            Error error =
                systemError(path, "could not be written", "free some space; the old file is untouched");
            file.reset();  // Windows removes no open file
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
    os::flushFolder(path.has_parent_path() ? path.parent_path() : Path{"."});
    return Done{};
}

std::string whyPathRefused(std::string_view relative) {
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

Result<Path> pathInside(const Path& root, std::string_view relative) {
    const auto refuse = [&](std::string why) {
        return Error{std::string{relative.substr(0, 200)}, "the path " + std::move(why),
                     "write a path inside the project, with '/', e.g. assets/player.png"};
    };
    if (std::string why = whyPathRefused(relative); !why.empty()) return refuse(std::move(why));
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
    const bool hidden = isHidden(folder);
    for (fs::recursive_directory_iterator at{folder, failed}, end; !hidden && !failed && at != end;
         at.increment(failed)) {
        if (at->is_regular_file(failed) && endsWith(at->path().filename().string(), ending)) {
            files.push_back(at->path().lexically_relative(folder).generic_string());
        }
    }
    for (std::string& file : mountedBelow(folder)) {
        if (endsWith(file, ending)) files.push_back(std::move(file));
    }
    std::sort(files.begin(), files.end());
    files.erase(std::unique(files.begin(), files.end()), files.end());
    return files;
}

std::uint64_t fileStamp(const Path& path) {
    std::error_code failed;
    const auto time = fs::last_write_time(path, failed);
    if (failed || isHidden(path)) return findMounted(path) ? 1 : 0;  // a mounted file does not change
    const std::uintmax_t size = fs::file_size(path, failed);
    const auto ticks = static_cast<std::uint64_t>(time.time_since_epoch().count());
    return mixBits(ticks ^ mixBits(failed ? 0 : size)) | 1;
}

}  // namespace plumb
