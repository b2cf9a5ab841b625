#pragma once

#include <memory>
#include <string>

#include "app/game_content.hpp"
#include "app/project.hpp"
#include "editor/model/play/play_mode.hpp"

namespace plumb::editor {

/// Creates a session that runs a scene exactly as the player application does: the same systems in the same
/// order, the same input, the same scene changes. @return null if the scene cannot be loaded; logs the reason
///
/// @param path  of the scene file, relative to the project
/// @param text  content of the scene file, including unsaved changes
std::unique_ptr<PlaySession> makeGameSession(const Project& project, const std::string& path,
                                             const std::string& text,
                                             const GameContent& content = engineContent());

}  // namespace plumb::editor
