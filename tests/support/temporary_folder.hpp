#pragma once

#include <atomic>
#include <filesystem>
#include <string>
#include <unistd.h>

namespace plumb::test {

/// A temporary folder for one test; the destructor removes it with its content.
class TemporaryFolder {
public:
    explicit TemporaryFolder(const std::filesystem::path& where = std::filesystem::temp_directory_path()) {
        static std::atomic<int> count{0};
        path = where / ("plumb_test_" + std::to_string(::getpid()) + "_" + std::to_string(count++));
        std::filesystem::create_directories(path);
    }
    ~TemporaryFolder() {
        std::error_code failed;
        std::filesystem::remove_all(path, failed);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    std::filesystem::path path;
};

/// Returns a folder in memory if there is one, for tests that write thousands of files.
inline std::filesystem::path memoryFolder() {
    const std::filesystem::path memory = "/dev/shm";
    std::error_code failed;
    return std::filesystem::is_directory(memory, failed) ? memory : std::filesystem::temp_directory_path();
}

}  // namespace plumb::test
