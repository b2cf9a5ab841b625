#pragma once

#include "app/game_content.hpp"
#include "core/file.hpp"

namespace plumb::editor {

/// Writes the definitions of everything that scripts can use to the file `.plumb/plumb.d.lua` of a project
/// that has scripts, for editors of text. A file with the same content is not written again. Logs errors.
/// @param project  the project's folder
void writeScriptDefinitions(const Path& project, const GameContent& content);

}  // namespace plumb::editor
