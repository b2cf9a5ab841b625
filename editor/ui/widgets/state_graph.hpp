#pragma once

#include "editor/model/assets/animation_edit.hpp"
#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// The states of an animation as a ring of boxes with arrows between them; the first one is where it begins.
/// A drag from one box to another adds a transition, a right click takes one out.
/// @param clip   that a new state plays
/// @param state  the selected one
void drawStateGraph(Ui& ui, AnimationEdit& edit, int clip, int& state);

}  // namespace plumb::editor::ui
