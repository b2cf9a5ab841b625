#pragma once

#include <string>
#include <vector>

namespace plumb::editor {

class Workspace;

// What the editor keeps of one project between two sessions, in its folder `.plumb`: no part of the project,
// and nothing of it is undone.

/// The grid, and how things snap, in `grid.json`. What is wrong in it stays as it is at first.
void readGrid(Workspace& workspace);
/// Writes it a moment after something changed. @param seconds  since the last frame
void tendGrid(Workspace& workspace, double seconds);
/// Writes it at once, when something changed.
void keepGrid(Workspace& workspace);

/// What was chosen in the palette, the last one first, in `recent.json`. @param most  how many of them
std::vector<std::string> recentChoices(const Workspace& workspace, std::size_t most);
void keepRecent(const Workspace& workspace, const std::vector<std::string>& choices);

}  // namespace plumb::editor
