#pragma once

#include "editor/model/cost/what_if_run.hpp"
#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// The error of each quality over what it costs, both axes logarithmic: what one buys for how much. The
/// present one is marked, the band below half a pixel is what cannot be seen.
/// @param size  px
/// @return the quality that was clicked, or -1
int drawWorkPrecision(Ui& ui, const WhatIfResult& result, ImVec2 size);

}  // namespace plumb::editor::ui
