#pragma once

#include "editor/ui/ui.hpp"
#include "math/rect.hpp"

namespace plumb::editor::ui {

/// Draws a warning over a running game whose scene has no enabled camera: the view is then centered at the
/// origin of the scene and may be empty.
/// @param picture  rectangle of the game image, px on screen
void drawMissingCameraWarning(const Ui& ui, const World& world, const AABB& picture);

}  // namespace plumb::editor::ui
