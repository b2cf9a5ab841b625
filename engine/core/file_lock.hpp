#pragma once

#include <optional>

#include "core/file.hpp"

namespace plumb {

/// A file that one program holds as long as it lives: others that ask are told no. The system takes it back
/// however the program ends.
class FileLock {
public:
    /// Makes the file, and its folders, where there are none.
    /// @return  nothing when another program holds it, or it cannot be made
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
