#include "core/file_lock.hpp"

#include <utility>

#include "core/os.hpp"

namespace plumb {

std::optional<FileLock> FileLock::take(const Path& path) {
    std::error_code failed;
    if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), failed);
    const int handle = os::lockFile(path);
    if (handle < 0) return std::nullopt;
    return FileLock{handle};
}

FileLock::FileLock(FileLock&& other) noexcept : handle_{std::exchange(other.handle_, -1)} {}

FileLock::~FileLock() {
    if (handle_ >= 0) os::unlockFile(handle_);
}

}  // namespace plumb
