#pragma once

#include <string>
#include <vector>

namespace plumb::editor {

class Workspace;

// Editor settings of one project, stored in its folder `.plumb`. They are not part of the project and not
// part of the undo history.

/// Reads the grid and snapping settings from `grid.json`. Invalid values keep their defaults.
void readGrid(Workspace& workspace);
/// Writes changed settings to `grid.json`, at most once per second. @param seconds  time since the last call
void updateGrid(Workspace& workspace, double seconds);
/// Writes changed settings to `grid.json` immediately.
void keepGrid(Workspace& workspace);

/// Reads the breakpoints in scripts from `breakpoints.json`.
void readBreakpoints(Workspace& workspace);
/// Writes the breakpoints in scripts to `breakpoints.json`.
void keepBreakpoints(const Workspace& workspace);

/// Reads the recent choices of the command palette from `recent.json`, latest first. @param most  maximum
/// number
std::vector<std::string> recentChoices(const Workspace& workspace, std::size_t most);
/// Writes the recent choices of the command palette to `recent.json`.
void keepRecent(const Workspace& workspace, const std::vector<std::string>& choices);

}  // namespace plumb::editor
