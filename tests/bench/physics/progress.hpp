#pragma once

#include <cstdio>
#include <string>
#include <unistd.h>

namespace plumb {

/// Shows the current activity in the last line of the terminal; does nothing if stderr is not a terminal.
inline void showProgress(const std::string& what) {
    if (isatty(STDERR_FILENO) == 0) return;
    std::fprintf(stderr, "\r\033[K%s", what.c_str());
    std::fflush(stderr);
}

}  // namespace plumb
