#include "platform/user_folder.hpp"

#include <cstdlib>

namespace plumb {

// SDL uses a relative path, and the current folder for an empty one. Both count as not set.
// Source: freedesktop.org, "XDG Base Directory Specification" 0.8
bool findUserFolder() {
    const auto isAbsolute = [](const char* path) { return path != nullptr && *path == '/'; };
    if (isAbsolute(std::getenv("XDG_DATA_HOME"))) return true;
    unsetenv("XDG_DATA_HOME");
    return isAbsolute(std::getenv("HOME"));
}

}  // namespace plumb
