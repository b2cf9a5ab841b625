#pragma once

#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// px that drawLogCounts takes; 0 when there is nothing to count.
float logCountsWidth(const Ui& ui);

}  // namespace plumb::editor::ui
