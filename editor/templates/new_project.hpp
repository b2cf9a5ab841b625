#pragma once

#include <string_view>

#include "core/file.hpp"

namespace plumb::editor {

/// Creates a project that is named like its folder, and prints what was done, for programs without a window.
/// @param from  id of a template
/// @return the program's exit code; 1 after an error, which is printed
int newProject(std::string_view from, const Path& folder);

}  // namespace plumb::editor
