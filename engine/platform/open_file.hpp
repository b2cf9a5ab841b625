#pragma once

#include <string>

#include "core/file.hpp"

namespace plumb {

/// Returns the address "file://..." of a file.
std::string urlOf(const Path& file);

/// Opens a file or folder in the program that the operating system assigns to its type.
/// @error  no program is assigned, or the system cannot start it
Result<Done> openFile(const Path& file);

}  // namespace plumb
