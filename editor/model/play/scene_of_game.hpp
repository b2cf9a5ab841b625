#pragma once

#include <string>

#include "editor/model/workspace.hpp"

namespace plumb::editor {

/// Path of the scene in which the game that plays is, without those laid over it; empty when none plays.
std::string sceneOfGame(const Workspace& workspace);

}  // namespace plumb::editor
