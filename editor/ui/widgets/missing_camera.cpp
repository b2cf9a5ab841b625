#include "editor/ui/widgets/missing_camera.hpp"

#include <algorithm>

#include "scene/components/drawing/camera.hpp"
#include "scene/components/transform.hpp"

namespace plumb::editor::ui {
namespace {

constexpr const char* kWords = "This scene has no camera. Entity > Add camera creates one.";

bool hasCamera(const World& world) {
    bool found = false;
    world.each<const Camera, const Transform>(
        [&](const Camera& camera, const Transform&) { found |= camera.enabled; });
    return found;
}

}  // namespace

void drawMissingCameraWarning(const Ui& ui, const World& world, const AABB& picture) {
    if (!ui.workspace.followsGame || hasCamera(world)) return;
    const float width = std::max(picture.size().x - ui.px(20.0f), 1.0f);
    const ImVec2 extent = ImGui::CalcTextSize(kWords, nullptr, false, width);
    const ImVec2 at{picture.center().x - extent.x * 0.5f, picture.center().y - extent.y * 0.5f};
    const ImVec2 to{at.x + extent.x, at.y + extent.y};
    const ImVec2 margin{ui.px(10.0f), ui.px(6.0f)};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled({at.x - margin.x, at.y - margin.y}, {to.x + margin.x, to.y + margin.y},
                       palette::kPopup, ui.px(5.0f));
    list.AddText(nullptr, 0.0f, at, palette::kText, kWords, nullptr, width);
    ui.widgets.mark("Viewport/no camera", {{at.x, at.y}, {to.x, to.y}}, kWords);
}

}  // namespace plumb::editor::ui
