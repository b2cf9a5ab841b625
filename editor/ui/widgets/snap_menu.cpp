#include "editor/ui/widgets/snap_menu.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/text.hpp"
#include "editor/model/actions.hpp"
#include "editor/ui/ui_compat.hpp"
#include "editor/ui/widgets/list_arrow.hpp"
#include "math/angle.hpp"

namespace plumb::editor::ui {
namespace {

constexpr float kSmallestCell = 1.0f;    // px
constexpr float kLargestCell = 4096.0f;  // px
constexpr float kLabels = 72.0f;         // px at scale 1

void label(const Ui& ui, const char* words) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("%s", words);
    ImGui::SameLine(ui.px(kLabels));
}

void choice(Ui& ui, std::string_view action, const char* name) {
    const bool on = isOn(*findAction(action), ui.workspace);
    if (ImGui::RadioButton(name, on)) runAction(ui.workspace, action);
    ui.widgets.mark(format("Snap/{}", name), on ? "on" : "off");
}

void editAngle(Ui& ui, GridSettings& grid) {
    bool on = grid.snapAngles;
    if (ImGui::Checkbox("##angles", &on)) runAction(ui.workspace, "view.snapAngles");
    ui.widgets.mark("Snap/Angles", on ? "on" : "off");
    tooltip("Rotates in steps of this angle while snapping is on.");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(ui.px(90.0f));
    float degrees = degreesFromRadians(grid.angle);
    if (ImGui::DragFloat("##angle", &degrees, 1.0f, 1.0f, 90.0f, "%.4g\xc2\xb0",
                         ImGuiSliderFlags_AlwaysClamp))
        grid.angle = radiansFromDegrees(degrees);
    ui.widgets.mark("Snap/angle", format("{}", degrees));
}

void editGrid(Ui& ui, GridSettings& grid) {
    std::array<float, 2> size{grid.size.x, grid.size.y};
    ImGui::SetNextItemWidth(ui.px(150.0f));
    if (ImGui::DragFloat2("##size", size.data(), 0.25f, kSmallestCell, kLargestCell, "%.4g px",
                          ImGuiSliderFlags_AlwaysClamp))
        grid.size = {std::clamp(size[0], kSmallestCell, kLargestCell),
                     std::clamp(size[1], kSmallestCell, kLargestCell)};
    ui.widgets.mark("Snap/size", format("{} {}", grid.size.x, grid.size.y));
}

void editColor(Ui& ui, GridSettings& grid) {
    const auto ratio = [](std::uint8_t part) { return static_cast<float>(part) / 255.0f; };
    const auto byte = [](float part) {
        return static_cast<std::uint8_t>(std::lround(std::clamp(part, 0.0f, 1.0f) * 255.0f));
    };
    const Color now = grid.color;
    std::array<float, 4> parts{ratio(now.r), ratio(now.g), ratio(now.b), ratio(now.a)};
    if (ImGui::ColorEdit4("##color", parts.data(),
                          ImGuiColorEditFlags_NoInputs | ImGuiColorEditFlags_AlphaPreview))
        grid.color = {byte(parts[0]), byte(parts[1]), byte(parts[2]), byte(parts[3])};
    ui.widgets.mark("Snap/color");
    ImGui::SameLine();
    if (ImGui::SmallButton("Reset")) grid.size = GridSettings{}.size, grid.color = GridSettings::kGridColor;
    ui.widgets.mark("Snap/reset");
}

}  // namespace

void snapMenu(Ui& ui) {
    const bool pressed = listArrow(ui, "Toolbar/snap settings", ImGui::GetItemRectSize().y);
    tooltip("Snap and grid settings");
    if (pressed) ImGui::OpenPopup("snap settings list");
    if (!ImGui::BeginPopup("snap settings list")) return;
    snapItems(ui);
    ImGui::EndPopup();
}

void snapItems(Ui& ui) {
    GridSettings& grid = ui.workspace.grid;
    label(ui, "Snap to");
    ImGui::BeginGroup();
    choice(ui, "view.snapGrid", "Grid");
    choice(ui, "view.snapHalf", "Half grid");
    choice(ui, "view.snapPixel", "Pixels");
    ImGui::EndGroup();
    label(ui, "Angles");
    editAngle(ui, grid);
    label(ui, "Grid");
    editGrid(ui, grid);
    label(ui, "Color");
    editColor(ui, grid);
    ImGui::Spacing();
    ImGui::TextDisabled("Ctrl inverts snapping for one drag.");
}

}  // namespace plumb::editor::ui
