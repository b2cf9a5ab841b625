#include "core/os.hpp"

#include <algorithm>
#include <cstdint>
#include <fcntl.h>
#include <io.h>
#include <limits>
#include <share.h>
#include <string>
#include <sys/stat.h>
#define WIN32_LEAN_AND_MEAN
#if !defined(NOMINMAX)
#define NOMINMAX
#endif
#include <windows.h>
// after it
#include <shellapi.h>

namespace plumb::os {

extern const bool kPathsAreUtf8;  // utf8.cpp

namespace {

constexpr std::size_t kHugePage = std::size_t{2} << 20;  // bytes

}  // namespace

std::FILE* openFile(const std::filesystem::path& path, const char* mode) {
    const std::wstring wide(mode, mode + std::char_traits<char>::length(mode));
    return kPathsAreUtf8 ? _wfopen(path.c_str(), wide.c_str()) : nullptr;
}

bool seek(std::FILE* file, std::uint64_t offset) {
    return _fseeki64(file, static_cast<std::int64_t>(offset), SEEK_SET) == 0;
}

bool flushToDisk(std::FILE* file) { return std::fflush(file) == 0 && _commit(_fileno(file)) == 0; }

void flushFolder(const std::filesystem::path&) {}  // NTFS journals its folders

int lockFile(const std::filesystem::path& path) {
    int handle = -1;
    _wsopen_s(&handle, path.c_str(), _O_RDWR | _O_CREAT, _SH_DENYRW, _S_IREAD | _S_IWRITE);
    return handle;
}

void unlockFile(int handle) { _close(handle); }

bool findUserFolder() { return true; }

bool reservingIsFree() { return sizeof(void*) == 8; }

std::size_t memoryStep() { return kHugePage; }

void* reserveMemory(std::size_t bytes) { return VirtualAlloc(nullptr, bytes, MEM_RESERVE, PAGE_READWRITE); }

void releaseMemory(void* start, std::size_t) { VirtualFree(start, 0, MEM_RELEASE); }

bool commitMemory(void* start, std::size_t bytes) {
    return VirtualAlloc(start, bytes, MEM_COMMIT, PAGE_READWRITE) != nullptr;
}

std::size_t addressLimit() { return std::numeric_limits<std::size_t>::max(); }

double processAge() {
    FILETIME created{}, exited{}, kernel{}, user{}, now{};
    if (GetProcessTimes(GetCurrentProcess(), &created, &exited, &kernel, &user) == 0) return 0.0;
    GetSystemTimeAsFileTime(&now);
    const auto ticks = [](const FILETIME& time) {  // of 100 ns
        return static_cast<std::int64_t>(std::uint64_t{time.dwHighDateTime} << 32 | time.dwLowDateTime);
    };
    return std::max(static_cast<double>(ticks(now) - ticks(created)) * 1e-7, 0.0);
}

bool hasThreads() { return true; }

/// Those of main() are in the code page of the system, which lacks most letters.
std::vector<std::string> arguments(int, const char* const*) {
    int count = 0;
    wchar_t** words = CommandLineToArgvW(GetCommandLineW(), &count);
    std::vector<std::string> arguments;
    for (int i = 1; words != nullptr && i < count; ++i) {
        std::string text(static_cast<std::size_t>(
                             WideCharToMultiByte(CP_UTF8, 0, words[i], -1, nullptr, 0, nullptr, nullptr)),
                         '\0');
        WideCharToMultiByte(CP_UTF8, 0, words[i], -1, text.data(), static_cast<int>(text.size()), nullptr,
                            nullptr);
        text.pop_back();  // the terminating zero
        arguments.push_back(std::move(text));
    }
    LocalFree(words);
    return arguments;
}

}  // namespace plumb::os
