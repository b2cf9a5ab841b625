#pragma once

#include "core/file.hpp"

namespace plumb::editor {

class Workspace;

/// Writes the open scene into a file of its own beside its file, which stays as it is:
/// "cave.mine.scene.json", or the next free name of that kind.
/// @return the new file
Result<Path> saveBeside(const Workspace& workspace);

}  // namespace plumb::editor
