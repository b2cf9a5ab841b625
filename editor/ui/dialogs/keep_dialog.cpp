#include "editor/ui/dialogs/keep_dialog.hpp"

#include <algorithm>

#include "core/text.hpp"
#include "editor/ui/ui_compat.hpp"

namespace plumb::editor::ui {
namespace {

constexpr const char* kTitle = "Keep changes?";

void drawValue(const std::string& text, ImU32 color) {
    ImGui::TableNextColumn();
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopStyleColor();
    tooltip(text);
}

void drawRow(Ui& ui, KeepRow& row, std::size_t index) {
    ImGui::PushID(static_cast<int>(index));
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::Checkbox("##keep", &row.keep);
    ui.widgets.mark(format("Keep/{}", index), row.keep ? "on" : "off");
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(row.entity.c_str());
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(row.field.c_str());
    if (row.edit.rewound) tooltip("You went back to before this change and played on from there.");
    drawValue(row.scene, palette::kTextDim);
    drawValue(row.played, row.edit.rewound ? palette::kTextDim : palette::kText);
    ui.widgets.mark(format("Keep/{}/value", index), row.played);
    ImGui::PopID();
}

void drawRows(Ui& ui, std::vector<KeepRow>& rows) {
    constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_RowBg | ImGuiTableFlags_ScrollY |
                                       ImGuiTableFlags_BordersInnerH | ImGuiTableFlags_SizingStretchProp;
    if (!ImGui::BeginTable("rows", 5, kFlags, {0.0f, -ui.px(44.0f)})) return;
    ImGui::TableSetupScrollFreeze(0, 1);
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, ui.px(26.0f));
    ImGui::TableSetupColumn("Entity", 0, 1.0f);
    ImGui::TableSetupColumn("Field", 0, 1.4f);
    ImGui::TableSetupColumn("In the scene", 0, 1.0f);
    ImGui::TableSetupColumn("Your change", 0, 1.0f);
    ImGui::TableHeadersRow();
    for (std::size_t i = 0; i < rows.size(); ++i) {
        drawRow(ui, rows[i], i);
    }
    ImGui::EndTable();
}

}  // namespace

void KeepDialog::draw(Ui& ui) {
    std::vector<KeepRow>& rows = ui.workspace.toKeep;
    if (rows.empty()) {
        open_ = false;
        return;
    }
    if (!open_) ImGui::OpenPopup(kTitle);
    open_ = true;
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float shown = std::min(static_cast<float>(rows.size()), 10.0f);
    const ImVec2 size{std::min(ui.px(680.0f), display.x - ui.px(20.0f)),
                      std::min(ui.px(150.0f + 30.0f * shown), display.y - ui.px(20.0f))};
    ImGui::SetNextWindowPos({(display.x - size.x) * 0.5f, (display.y - size.y) * 0.4f});
    ImGui::SetNextWindowSize(size);
    if (!ImGui::BeginPopupModal(kTitle, nullptr, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove)) {
        rows.clear();  // Esc
        return;
    }
    ImGui::TextDisabled(
        "You changed this while the game played. What is ticked goes into the scene as one step of undo.");
    drawRows(ui, rows);
    const auto ticked = std::count_if(rows.begin(), rows.end(), [](const KeepRow& row) { return row.keep; });
    ImGui::SetCursorPosY(size.y - ui.px(40.0f));
    const ImVec2 button{ui.px(120.0f), 0.0f};
    ImGui::PushStyleColor(ImGuiCol_Button, ticked > 0 ? palette::kAccentSoft : palette::kNothing);
    const bool keep = ImGui::Button(format("Keep {}###keep", ticked).c_str(), button);
    ImGui::PopStyleColor();
    ui.widgets.mark("Keep/keep", format("{}", ticked));
    ImGui::SameLine();
    const bool none = ImGui::Button("Keep nothing", button);
    ui.widgets.mark("Keep/nothing");
    if (none) rows.clear();
    if (keep) ui.workspace.keepTicked();
    if (keep || none) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

}  // namespace plumb::editor::ui
