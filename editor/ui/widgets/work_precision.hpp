#pragma once

#include "editor/model/cost/what_if_run.hpp"
#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// Draws a diagram of the largest error of each physics quality over its time per tick, both axes
/// logarithmic. The present quality is marked; a band shows errors below half a pixel, which are invisible.
/// @param size  size of the diagram, px
/// @return the clicked quality, or -1
int drawWorkPrecision(Ui& ui, const WhatIfResult& result, ImVec2 size);

}  // namespace plumb::editor::ui
