#pragma once

#include "editor/ui/ui.hpp"
#include "reflect/type_info.hpp"

namespace plumb::editor::ui {

/// Draws a small icon for the kind of an asset into the lower right
/// corner of its thumbnail; nothing for files that are not assets.
/// @param corner  lower right corner of the thumbnail, px on screen
void drawAssetMark(const Ui& ui, ImDrawList& list, AssetKind kind, ImVec2 corner);

}  // namespace plumb::editor::ui
