#pragma once

#include "editor/ui/ui.hpp"
#include "math/rect.hpp"

namespace plumb::editor::ui {

/// Over the picture of a game that plays in a scene without a camera: what is seen is what is around the
/// origin of the scene, which may be nothing.
/// @param picture  px on screen
void sayMissingCamera(const Ui& ui, const World& world, const AABB& picture);

}  // namespace plumb::editor::ui
