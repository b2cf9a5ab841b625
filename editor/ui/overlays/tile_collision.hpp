#pragma once

#include "editor/model/workspace.hpp"

namespace plumb::editor::ui {

/// The collision shapes of the tiles of all solid layers that are seen; one-way tiles with an arrow.
void drawTileCollision(const Workspace& workspace, const World& world, Overlay& overlay);

}  // namespace plumb::editor::ui
