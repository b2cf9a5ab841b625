#pragma once

#include <span>
#include <vector>

#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// Begins a toolbar window, colored by the play state (stopped, playing, paused). Call ImGui::End() after it.
void beginBar(const Ui& ui, const char* name, ImVec2 at, ImVec2 size, ImVec2 padding);

/// A group of adjacent toolbar widgets, which are shown, or moved to the overflow list, together.
struct BarGroup {
    float width = 0.0f;  ///< px
    int worth = 0;       ///< groups with lower values move to the overflow list first
};

/// Selects the groups that a toolbar shows: all if they fit, else those with the highest worth beside a
/// button for the overflow list.
/// @param room  width between the margins, px
/// @param gap   distance between two groups, px
/// @param more  width of the overflow button, px
std::vector<bool> shownGroups(std::span<const BarGroup> groups, float room, float gap, float more);

}  // namespace plumb::editor::ui
