#pragma once

#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// px of the bar below the scene while a game plays.
float timelineHeight(const Ui& ui);

/// The last 30 s of the game that plays: dragging along them shows what was, buttons go on from there.
/// Marks: what was changed by hand.
void drawTimeline(Ui& ui, ImVec2 from, ImVec2 size);

}  // namespace plumb::editor::ui
