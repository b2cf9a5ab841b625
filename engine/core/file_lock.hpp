#pragma once

#include <optional>

#include "core/file.hpp"

namespace plumb {

/// A lock file that one process holds until it exits; another process that tries
/// to lock it fails. The system releases the lock however the process ends.
class FileLock {
public:
    /// Creates the file and its folders if necessary.
    /// @return nothing if another process holds the lock, or the file cannot be created
    static std::optional<FileLock> take(const Path& path);

    ~FileLock();
    FileLock(FileLock&& other) noexcept;
    FileLock& operator=(FileLock&&) = delete;
    FileLock(const FileLock&) = delete;
    FileLock& operator=(const FileLock&) = delete;

private:
    explicit FileLock(int handle) : handle_{handle} {}

    int handle_ = -1;
};

}  // namespace plumb
