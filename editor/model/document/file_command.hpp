#pragma once

#include "editor/model/document/command.hpp"

namespace plumb::editor {

/// A command that writes project files immediately. It does not affect whether the open scene counts as
/// saved, because it changes the scene's file together with the scene.
class FileCommand : public Command {};

}  // namespace plumb::editor
