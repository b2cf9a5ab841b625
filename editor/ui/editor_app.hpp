#pragma once

#include "editor/model/project/editor_options.hpp"

namespace plumb::editor::ui {

/// Runs the program plumb-editor. @return its exit code
int runEditor(const EditorOptions& options);

}  // namespace plumb::editor::ui
