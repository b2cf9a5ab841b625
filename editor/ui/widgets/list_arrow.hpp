#pragma once

#include <string>

#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// Width of listArrow(), px.
float listArrowWidth(const Ui& ui);
/// Draws a narrow arrow beside a button, which opens the button's list. @return true if it was clicked
/// @param height  height of the button, px
bool listArrow(Ui& ui, const std::string& path, float height);

}  // namespace plumb::editor::ui
