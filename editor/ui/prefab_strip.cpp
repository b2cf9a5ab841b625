#include "editor/ui/prefab_strip.hpp"

#include <cmath>

#include "core/text.hpp"
#include "editor/model/actions.hpp"
#include "editor/model/prefabs/prefab_visit.hpp"
#include "editor/ui/icons.hpp"
#include "editor/ui/ui_compat.hpp"

namespace plumb::editor::ui {
namespace {

constexpr float kHeight = 32.0f;  // px at scale 1: height of the strip
constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus;

/// Returns the name of a file without folder and extensions: "level1" for "scenes/level1.scene.json".
std::string shortName(std::string_view path) {
    const std::string_view file = path.substr(path.rfind('/') + 1);
    return std::string{file.substr(0, file.find('.'))};
}

void drawBack(Ui& ui) {
    const std::string behind = fileToReturnTo(ui.workspace);
    ImGui::BeginDisabled(behind.empty());
    const std::string label = behind.empty() ? "Back" : format("Back to {}", shortName(behind));
    if (ImGui::Button(label.c_str())) runAction(ui.workspace, "entity.leavePrefab");
    ImGui::EndDisabled();
    ui.widgets.mark("Prefab/Back", behind);
    const Action& action = *findAction("entity.leavePrefab");
    tooltip(format("To {}  ({})", behind, ui.workspace.settings.keys.shownOf(action).text()));
}

void drawContents(Ui& ui, float width) {
    const std::string& path = ui.workspace.document.scenePath;
    drawBack(ui);
    ImGui::SameLine(0.0f, ui.px(14.0f));
    const ImVec2 at = ImGui::GetCursorScreenPos();
    drawIcon(*ImGui::GetWindowDrawList(), Icon::Star,
             {at.x + ui.px(8.0f), at.y + std::floor(ImGui::GetFrameHeight() * 0.5f)}, ui.px(14.0f),
             palette::kViolet);
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ui.px(22.0f));
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(format("Prefab {}", shortName(path)).c_str());
    ui.widgets.mark("Prefab/name", path);
    tooltip(path);
    const char* hint = ui.workspace.unsaved() ? "Saving updates all instances of this prefab."
                                              : "Changes here change all instances of this prefab.";
    ImGui::SameLine(0.0f, ui.px(14.0f));
    if (ImGui::GetCursorPosX() + ImGui::CalcTextSize(hint).x < width) ImGui::TextDisabled("%s", hint);
}

}  // namespace

float drawPrefabStrip(Ui& ui, float top, float width) {
    if (!editsPrefab(ui.workspace)) return 0.0f;
    const float height = ui.px(kHeight);
    ImGui::SetNextWindowPos({0.0f, top});
    ImGui::SetNextWindowSize({width, height});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding,
                        {ui.px(8.0f), std::floor((height - ImGui::GetFrameHeight()) * 0.5f)});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1.0f, 1.0f});
    ImGui::PushStyleColor(ImGuiCol_WindowBg, palette::kHeader);
    ImGui::Begin("prefab strip", nullptr, kFlags);
    ImGui::PopStyleColor();
    ImGui::PopStyleVar(2);
    const ImVec2 from = ImGui::GetWindowPos();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 to{from.x + width, from.y + height};
    list.PushClipRect(from, to);  // the window's own clip rectangle excludes half of its padding
    list.AddRectFilled({from.x, to.y - ui.px(2.0f)}, to, palette::kViolet);
    list.PopClipRect();
    drawContents(ui, width);
    ImGui::End();
    return height;
}

}  // namespace plumb::editor::ui
