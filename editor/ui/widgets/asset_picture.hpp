#pragma once

#include <string_view>

#include <imgui.h>

#include "editor/ui/ui.hpp"
#include "math/rect.hpp"
#include "reflect/type_info.hpp"

namespace plumb::editor::ui {

/// Draws what a file looks like into a box: a picture itself, a tileset by its picture, an animation playing,
/// a prefab by its first part that can be seen; everything else by a sign. Nothing is enlarged beyond whole pixels.
/// @param box      px on screen
/// @param playing  s since the mouse came; animations move by it
void drawAsset(Ui& ui, ImDrawList& list, AssetKind kind, std::string_view path, const AABB& box,
               double playing);

inline constexpr const char* kAssetPayload = "asset";  ///< what is dragged: the path, with a 0 behind it

/// Makes the last item something that files can be dropped on. @return the path that was dropped; empty: none
/// @param hovering  set to the path while it is held over the item
std::string acceptAsset(std::string& hovering);

}  // namespace plumb::editor::ui
