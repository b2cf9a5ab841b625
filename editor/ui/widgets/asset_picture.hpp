#pragma once

#include <string_view>

#include <imgui.h>

#include "editor/ui/ui.hpp"
#include "math/rect.hpp"
#include "reflect/type_info.hpp"

namespace plumb::editor::ui {

/// Draws the thumbnail of an asset into a box: an image or the image of a
/// tileset, a playing animation, the first visible entity of a prefab, or a
/// card with the kind of file. Images are enlarged by whole factors only.
/// @param box      target rectangle, px on screen
/// @param playing  playback time of an animation, s
void drawAsset(Ui& ui, ImDrawList& list, AssetKind kind, std::string_view path, const AABB& box,
               double playing);

/// Draws a whole image over a checkerboard, however long it is. @param box  target rectangle, px on screen
void drawImage(Ui& ui, ImDrawList& list, std::string_view path, const AABB& box);

inline constexpr const char* kAssetPayload = "asset";  ///< type of a drag payload: a null-terminated path

/// Makes the last item a drop target for assets. @return the dropped path; empty: none
/// @param hovering  set to the path that is dragged over the item; empty: none
std::string acceptAsset(std::string& hovering);

}  // namespace plumb::editor::ui
