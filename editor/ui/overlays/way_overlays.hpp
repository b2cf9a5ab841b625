#pragma once

#include "editor/model/view/overlay.hpp"
#include "editor/model/workspace.hpp"

namespace plumb::editor::ui {

/// Draws the area that the player can reach: green with
/// one jump, blue with more; bars mark landing positions.
void drawJumpReach(const Workspace& workspace, const World& world, Overlay& overlay);

/// Draws the fixed paths of platforms and walkers.
void drawFixedPaths(const Workspace& workspace, const World& world, Overlay& overlay);

/// Draws past and predicted trajectories of entities.
void drawTrajectories(const Workspace& workspace, const World& world, Overlay& overlay);

}  // namespace plumb::editor::ui
