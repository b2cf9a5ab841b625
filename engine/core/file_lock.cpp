#include "core/file_lock.hpp"

#include <utility>

#ifdef _WIN32
#include <fcntl.h>
#include <io.h>
#include <share.h>
#include <sys/stat.h>
#else
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>
#endif

namespace plumb {
namespace {

/// Opens and locks the file. @return -1 if another process holds the lock, or the file cannot be created
int takeFile(const Path& path) {
#ifdef _WIN32
    int handle = -1;
    _wsopen_s(&handle, path.c_str(), _O_RDWR | _O_CREAT, _SH_DENYRW, _S_IREAD | _S_IWRITE);
    return handle;
#else
    const int handle = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
    if (handle >= 0 && ::flock(handle, LOCK_EX | LOCK_NB) != 0) {
        ::close(handle);
        return -1;
    }
    return handle;
#endif
}

}  // namespace

std::optional<FileLock> FileLock::take(const Path& path) {
    std::error_code failed;
    if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), failed);
    const int handle = takeFile(path);
    if (handle < 0) return std::nullopt;
    return FileLock{handle};
}

FileLock::FileLock(FileLock&& other) noexcept : handle_{std::exchange(other.handle_, -1)} {}

FileLock::~FileLock() {
    if (handle_ < 0) return;
#ifdef _WIN32
    _close(handle_);
#else
    ::close(handle_);
#endif
}

}  // namespace plumb
