#pragma once

#include <span>
#include <vector>

#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// A bar over the whole width of the window, at a height; in the color of what the editor does. Ends with
/// ImGui::End.
void beginBar(const Ui& ui, const char* name, ImVec2 at, ImVec2 size, ImVec2 padding);

/// Some widgets of a bar that stand together, and are in its list together where they have no room.
struct BarGroup {
    float width = 0.0f;  ///< px
    int worth = 0;       ///< of two groups the one that is worth less goes into the list first
};

/// Which groups a bar shows: all when they fit, else those that are worth more, and a button for the rest.
/// @param room  px, between the margins
/// @param gap   px, between two groups
/// @param more  px, of the button
std::vector<bool> shownGroups(std::span<const BarGroup> groups, float room, float gap, float more);

}  // namespace plumb::editor::ui
