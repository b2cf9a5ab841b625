#pragma once

#include <string>

#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// The narrow arrow beside a button, behind which its list is. As high as the button, so that both stand in
/// one line. @return whether it was clicked
float listArrowWidth(const Ui& ui);
bool listArrow(Ui& ui, const std::string& path, float height);

}  // namespace plumb::editor::ui
