#pragma once

#include <atomic>
#include <filesystem>
#include <string>
#include <unistd.h>

namespace plumb::test {

/// A folder of its own for one test, removed with everything in it at the end.
class TemporaryFolder {
public:
    TemporaryFolder() {
        static std::atomic<int> count{0};
        path = std::filesystem::temp_directory_path() /
               ("plumb_test_" + std::to_string(::getpid()) + "_" + std::to_string(count++));
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

}  // namespace plumb::test
