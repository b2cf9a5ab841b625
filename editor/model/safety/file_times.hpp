#pragma once

#include <string>

#include "core/file.hpp"

namespace plumb::editor {

/// Returns the local time at which a file was last written, e.g. "22 Nov 02:15:03"; empty if it does not
/// exist.
std::string whenWritten(const Path& path);

}  // namespace plumb::editor
