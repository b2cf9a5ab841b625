#pragma once

#include <cstdio>
#include <string>
#include <unistd.h>

namespace plumb {

/// Says in the terminal's last line what runs now; nothing where a file listens.
inline void showProgress(const std::string& what) {
    if (isatty(STDERR_FILENO) == 0) return;
    std::fprintf(stderr, "\r\033[K%s", what.c_str());
    std::fflush(stderr);
}

}  // namespace plumb
