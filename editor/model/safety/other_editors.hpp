#pragma once

#include "core/file.hpp"

namespace plumb::editor {

/// Whether an editor has the project open at this moment: one that keeps a journal in it.
bool isOpenInAnEditor(const Path& project);

}  // namespace plumb::editor
