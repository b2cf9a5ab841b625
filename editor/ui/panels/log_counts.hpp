#pragma once

#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// Width of the text drawn by drawLogCounts(), px; 0 if the log has no errors and no warnings.
float logCountsWidth(const Ui& ui);

}  // namespace plumb::editor::ui
