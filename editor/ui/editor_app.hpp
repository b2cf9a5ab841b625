#pragma once

#include "editor/model/project/editor_options.hpp"

namespace plumb::editor::ui {

/// What plumb-editor does. @return the program's exit code
int runEditor(const EditorOptions& options);

}  // namespace plumb::editor::ui
