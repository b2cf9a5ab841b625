#pragma once

#include <string>

#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// For each overlay of entities and each layer of the physics: shown of none, of what is selected, or of all.
/// @param path  how tests call them
void physicsLayerItems(Ui& ui, const std::string& path);

}  // namespace plumb::editor::ui
