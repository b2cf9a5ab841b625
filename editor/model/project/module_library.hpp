#pragma once

#include "app/module.hpp"
#include "core/file.hpp"
#include "core/result.hpp"

namespace plumb::editor {

/// Loads the code of a project into this program, where it stays until the program ends.
/// @param library  the library that contains the code; may be overwritten afterwards
/// @param folder   receives a copy of it for a moment
/// @error it is missing, was built for another version of this program, or does not describe a module
Result<Module> loadModule(const Path& library, const Path& folder);

}  // namespace plumb::editor
