#include "platform/process_time.hpp"

#include <algorithm>

#include "core/clock.hpp"

#if defined(__linux__)
#include <cstdio>
#include <cstdlib>
#include <string>
#include <time.h>
#include <unistd.h>
#endif

namespace plumb {
namespace {

#if defined(__linux__)
/// Seconds between the start of the machine and that of this process; below 0 if it is unknown.
double startedAt() {
    std::FILE* file = std::fopen("/proc/self/stat", "r");  // its size is reported as 0, so not readFile()
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

/// Seconds between the start of the program and the first call of this function.
double ranBefore() {
    timespec now{};
    const double started = startedAt();
    if (started < 0.0 || clock_gettime(CLOCK_BOOTTIME, &now) != 0) return 0.0;
    return std::max(static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9 - started, 0.0);
}
#else
double ranBefore() { return 0.0; }
#endif

}  // namespace

double processSeconds() {
    static const double begin = wallSeconds() - ranBefore();
    return wallSeconds() - begin;
}

}  // namespace plumb
