#pragma once

#include "editor/model/workspace.hpp"

namespace plumb::editor::ui {

/// Draws the collision shapes of the tiles of all visible solid layers; one-way tiles have an arrow.
void drawTileCollision(const Workspace& workspace, const World& world, Overlay& overlay);

}  // namespace plumb::editor::ui
