#pragma once

#include "core/file.hpp"

namespace plumb::editor {

class Workspace;

/// Writes the open scene to a new file in the folder of its own file, which stays unchanged. The name is e.g.
/// "cave.mine.scene.json", or "cave.mine2.scene.json" if that exists.
/// @return path of the new file
Result<Path> saveBeside(const Workspace& workspace);

}  // namespace plumb::editor
