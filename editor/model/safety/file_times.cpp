#include "editor/model/safety/file_times.hpp"

#include <chrono>
#include <ctime>

namespace plumb::editor {

std::string whenWritten(const Path& path) {
    using FileTime = std::filesystem::file_time_type;
    using std::chrono::system_clock;
    std::error_code failed;
    const FileTime time = std::filesystem::last_write_time(path, failed);
    if (failed) return {};
    const auto ago = std::chrono::duration_cast<system_clock::duration>(FileTime::clock::now() - time);
    const std::time_t seconds = system_clock::to_time_t(system_clock::now() - ago);
    std::tm parts{};
#ifdef _WIN32
    localtime_s(&parts, &seconds);
#else
    localtime_r(&seconds, &parts);
#endif
    char text[64];
    return {text, std::strftime(text, sizeof text, "%d %b %H:%M:%S", &parts)};
}

}  // namespace plumb::editor
