#include "core/os.hpp"

#include <algorithm>
#include <cstdlib>
#include <fcntl.h>
#include <limits>
#include <string>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <time.h>
#include <unistd.h>

namespace plumb::os {
namespace {

constexpr std::size_t kHugePage = std::size_t{2} << 20;  // bytes

#if defined(__linux__)
/// Seconds between the start of the machine and that of this process; below 0 if it is unknown.
double startedAt() {
    std::FILE* file = std::fopen("/proc/self/stat", "r");
    if (file == nullptr) return -1.0;
    std::string text(1024, '\0');
    text.resize(std::fread(text.data(), 1, text.size(), file));
    std::fclose(file);
    // The name in parentheses may contain spaces; after it, the start time is the 20th word.
    std::size_t at = text.rfind(')');
    for (int word = 0; word < 20 && at != std::string::npos; ++word) at = text.find(' ', at + 1);
    if (at == std::string::npos) return -1.0;
    return std::strtod(text.c_str() + at, nullptr) / static_cast<double>(sysconf(_SC_CLK_TCK));
}
#endif

}  // namespace

std::FILE* openFile(const std::filesystem::path& path, const char* mode) {
    return std::fopen(path.c_str(), mode);
}

bool seek(std::FILE* file, std::uint64_t offset) {
    return ::fseeko(file, static_cast<off_t>(offset), SEEK_SET) == 0;
}

bool flushToDisk(std::FILE* file) { return std::fflush(file) == 0 && ::fsync(::fileno(file)) == 0; }

void flushFolder(const std::filesystem::path& folder) {
    const int handle = ::open(folder.c_str(), O_RDONLY);
    if (handle < 0) return;
    ::fsync(handle);
    ::close(handle);
}

int lockFile(const std::filesystem::path& path) {
    const int handle = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
    if (handle < 0 || ::flock(handle, LOCK_EX | LOCK_NB) == 0) return handle;
    ::close(handle);
    return -1;
}

void unlockFile(int handle) { ::close(handle); }

// A relative path, and an empty one, which would be the current folder, count as not set.
// Source: freedesktop.org, "XDG Base Directory Specification" 0.8
bool findUserFolder() {
    const auto isAbsolute = [](const char* path) { return path != nullptr && *path == '/'; };
    if (isAbsolute(std::getenv("XDG_DATA_HOME"))) return true;
    unsetenv("XDG_DATA_HOME");
    return isAbsolute(std::getenv("HOME"));
}

bool reservingIsFree() { return sizeof(void*) == 8; }

std::size_t memoryStep() { return kHugePage; }

void* reserveMemory(std::size_t bytes) {
    int flags = MAP_PRIVATE | MAP_ANONYMOUS;
#if defined(MAP_NORESERVE)
    flags |= MAP_NORESERVE;
#endif
    void* start = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, flags, -1, 0);
    return start == MAP_FAILED ? nullptr : start;
}

void releaseMemory(void* start, std::size_t bytes) { munmap(start, bytes); }

/// All of it is usable; large parts get huge pages. Small ones use small pages, so that a small world takes
/// little memory.
bool commitMemory([[maybe_unused]] void* start, [[maybe_unused]] std::size_t bytes) {
#if defined(MADV_HUGEPAGE)
    if (bytes < kHugePage) return true;
    const auto address = reinterpret_cast<std::size_t>(start);
    const std::size_t first = (address + kHugePage - 1) / kHugePage * kHugePage;
    const std::size_t end = (address + bytes) / kHugePage * kHugePage;
    if (first < end) madvise(reinterpret_cast<void*>(first), end - first, MADV_HUGEPAGE);
#endif
    return true;
}

std::size_t addressLimit() {
    rlimit limit{};
    if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY)
        return std::numeric_limits<std::size_t>::max();
    return static_cast<std::size_t>(limit.rlim_cur);
}

double processAge() {
#if defined(__linux__)
    timespec now{};
    const double started = startedAt();
    if (started < 0.0 || clock_gettime(CLOCK_BOOTTIME, &now) != 0) return 0.0;
    return std::max(static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9 - started, 0.0);
#else
    return 0.0;
#endif
}

bool hasThreads() { return true; }

std::vector<std::string> arguments(int count, const char* const* words) {
    return {words + std::min(count, 1), words + count};
}

}  // namespace plumb::os
