#include "editor/ui/widgets/sheet_cell.hpp"

#include <algorithm>
#include <array>

#include "editor/ui/scene_picture.hpp"
#include "editor/ui/ui_compat.hpp"

namespace plumb::editor::ui {

void drawSheetCell(Ui& ui, const AnimationEdit& edit, const AnimationFrame& frame, const AABB& box) {
    const AnimationSet& set = edit.set();
    if (ui.picture == nullptr || set.texture.empty() || set.frameWidth <= 0 || set.frameHeight <= 0) return;
    const Vec2 size{static_cast<float>(set.frameWidth), static_cast<float>(set.frameHeight)};
    const float zoom = std::min(box.size().x / size.x, box.size().y / size.y);
    const Vec2 half = size * (zoom * 0.5f);
    const Vec2 at = box.center();
    const TexturePart part = ui.picture->part(set.texture, edit.cellOf(frame));
    const std::array corners{ImVec2{at.x - half.x, at.y - half.y}, ImVec2{at.x + half.x, at.y - half.y},
                             ImVec2{at.x + half.x, at.y + half.y}, ImVec2{at.x - half.x, at.y + half.y}};
    const std::array uv{part.from, Vec2{part.to.x, part.from.y}, part.to, Vec2{part.from.x, part.to.y}};
    quadOfPixels(*ImGui::GetWindowDrawList(), textureId(part.texture), corners, uv, IM_COL32_WHITE);
}

}  // namespace plumb::editor::ui
