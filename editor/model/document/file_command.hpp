#pragma once

#include "editor/model/document/command.hpp"

namespace plumb::editor {

/// A command that writes files of the project, at once. The open scene is as much saved afterwards as it was
/// before: what such a command changes in the scene, it changes in the scene's file too.
class FileCommand : public Command {};

}  // namespace plumb::editor
