#pragma once

#include <string>

#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// Draws radio buttons per overlay and physics layer: show it for no entity, the selected ones, or all.
/// @param path  prefix of the widget paths, for tests
void physicsLayerItems(Ui& ui, const std::string& path);

}  // namespace plumb::editor::ui
