#pragma once

#include <string>

#include "core/file.hpp"

namespace plumb::editor {

/// When a file was written: "22 Nov 02:15:03", local time; empty when there is none.
std::string whenWritten(const Path& path);

}  // namespace plumb::editor
