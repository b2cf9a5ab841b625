#pragma once

#include <memory>
#include <string>

#include "app/project.hpp"
#include "editor/model/play/play_mode.hpp"

namespace plumb::editor {

/// Plays a scene by the rules of the player: the same systems in the same order, the same input, the same
/// changes of scene. Nothing when the scene cannot be loaded; the log says why.
///
/// @param path  of the scene in the project
/// @param text  what it is now, with changes that are not saved
std::unique_ptr<PlaySession> makeGameSession(const Project& project, const std::string& path,
                                             const std::string& text);

}  // namespace plumb::editor
