#pragma once

#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// Height of the bar below the viewport while a game runs, px.
float timelineHeight(const Ui& ui);

/// Draws the timeline of the last 30 s of the running game: dragging shows past ticks, buttons step or resume
/// the game from there. Diamonds mark edits made during play.
void drawTimeline(Ui& ui, ImVec2 from, ImVec2 size);

}  // namespace plumb::editor::ui
