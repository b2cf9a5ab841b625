#include "editor/ui/widgets/list_arrow.hpp"

#include "editor/ui/icons.hpp"

namespace plumb::editor::ui {
namespace {

constexpr float kWidth = 20.0f;  // px at scale 1
constexpr float kSign = 12.0f;

}  // namespace

float listArrowWidth(const Ui& ui) { return ui.px(kWidth); }

bool listArrow(Ui& ui, const std::string& path, float height) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = listArrowWidth(ui);
    const bool clicked = ImGui::InvisibleButton(path.c_str(), {width, height});
    ui.widgets.mark(path);
    const bool hovered = ImGui::IsItemHovered();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (hovered) list.AddRectFilled(at, {at.x + width, at.y + height}, palette::kHover, ui.px(4.0f));
    drawIcon(list, Icon::Chevron, {at.x + width * 0.5f, at.y + height * 0.5f}, ui.px(kSign),
             hovered ? palette::kText : palette::kTextDim);
    return clicked;
}

}  // namespace plumb::editor::ui
