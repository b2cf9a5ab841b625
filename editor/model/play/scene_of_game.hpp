#pragma once

#include <string>

#include "editor/model/workspace.hpp"

namespace plumb::editor {

/// Returns the path of the running game's main scene, without additively loaded ones; empty if no game runs.
std::string sceneOfGame(const Workspace& workspace);

}  // namespace plumb::editor
