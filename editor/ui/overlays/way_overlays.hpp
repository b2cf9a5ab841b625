#pragma once

#include "editor/model/view/overlay.hpp"
#include "editor/model/workspace.hpp"

namespace plumb::editor::ui {

/// Where the player gets to: green with one jump, blue with more; a bar where it can land.
void drawJumpReach(const Workspace& workspace, const World& world, Overlay& overlay);

/// The ways on which components move things to and fro.
void drawSetWays(const Workspace& workspace, const World& world, Overlay& overlay);

/// The ways behind and ahead of things.
void drawTrajectories(const Workspace& workspace, const World& world, Overlay& overlay);

}  // namespace plumb::editor::ui
