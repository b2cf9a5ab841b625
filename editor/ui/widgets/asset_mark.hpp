#pragma once

#include "editor/ui/ui.hpp"
#include "reflect/type_info.hpp"

namespace plumb::editor::ui {

/// A small sign of what kind of file it is, in the lower right corner of its picture. Files that games do not
/// load have none.
/// @param corner  of the picture, px
void drawAssetMark(const Ui& ui, ImDrawList& list, AssetKind kind, ImVec2 corner);

}  // namespace plumb::editor::ui
