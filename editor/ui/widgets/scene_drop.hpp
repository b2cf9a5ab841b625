#pragma once

#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// Makes the last item, the scene view, a drop target for
/// assets; a dragged asset is previewed at its position.
/// @param corner  upper left corner of the scene view, px on screen
void dropIntoScene(Ui& ui, Vec2 corner);

}  // namespace plumb::editor::ui
