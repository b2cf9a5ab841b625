#pragma once

#include "core/file.hpp"

namespace plumb::editor {

/// True if a running editor has the project open, i.e. holds the lock of a journal folder in it.
bool isOpenInAnEditor(const Path& project);

}  // namespace plumb::editor
