#pragma once

#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// Makes the last item, the scene, something that files of the browser are dropped on; what is carried over
/// it is shown where it would stand.
/// @param corner  px on screen, of the scene's top left
void dropIntoScene(Ui& ui, Vec2 corner);

}  // namespace plumb::editor::ui
