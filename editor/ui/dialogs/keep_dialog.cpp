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
    if (row.edit.rewound) tooltip("The game was rewound to before this change and continued from there.");
    drawValue(row.scene, palette::kTextDim);
    drawValue(row.played, row.edit.rewound ? palette::kTextDim : palette::kText);
    ui.widgets.mark(format("Keep/{}/value", index), row.played);
    ImGui::PopID();
}

void drawRows(Ui& ui, std::vector<KeepRow>& rows) {
    constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_RowBg | ImGuiTableFlags_ScrollY |
                                       ImGuiTableFlags_BordersInnerH | ImGuiTableFlags_SizingStretchProp;
    if (!ImGui::BeginTable("rows", 5, kFlags, {0.0f, -ui.px(44.0f)})) return;
    joinFocusOrder();
    ImGui::TableSetupScrollFreeze(0, 1);
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, ui.px(26.0f));
    ImGui::TableSetupColumn("Entity", 0, 1.0f);
    ImGui::TableSetupColumn("Field", 0, 1.4f);
    ImGui::TableSetupColumn("In the scene", 0, 1.0f);
    ImGui::TableSetupColumn("Your change", 0, 1.0f);
    tableTitles();
    for (std::size_t i = 0; i < rows.size(); ++i) {
        drawRow(ui, rows[i], i);
    }
    ImGui::EndTable();
}

}  // namespace

void KeepDialog::draw(Ui& ui) {
    std::vector<KeepRow>& rows = ui.workspace.offeredChanges;
    if (question_.ask(!rows.empty())) {  // closed with Esc
        rows.clear();
        ui.workspace.notice = "Nothing was kept";
    }
    const float shown = std::min(static_cast<float>(rows.size()), 10.0f);
    if (!beginDialog(ui, kTitle, {680.0f, 150.0f + 30.0f * shown})) return;
    if (rows.empty()) {  // a game was started again, or another scene was opened
        ImGui::CloseCurrentPopup();
        ImGui::EndPopup();
        return;
    }
    ImGui::PushStyleColor(ImGuiCol_Text, palette::kTextDim);
    ImGui::TextWrapped(
        "You changed these fields while the game ran. The ticked changes are copied to the scene as one undo "
        "step.");
    ImGui::PopStyleColor();
    drawRows(ui, rows);
    const auto ticked = std::count_if(rows.begin(), rows.end(), [](const KeepRow& row) { return row.keep; });
    dialogFoot(ui);
    const std::string label = format("Keep {}###keep", ticked);
    const bool keep = ticked > 0 ? defaultButton(ui, label.c_str(), 120.0f, "Keep/keep")
                                 : footButton(ui, label.c_str(), 120.0f, "Keep/keep", palette::kNothing);
    ui.widgets.mark("Keep/keep", format("{}", ticked));
    ImGui::SameLine();
    const bool none = footButton(ui, "Keep nothing", 120.0f, "Keep/nothing");
    if (none) rows.clear();
    if (keep) ui.workspace.keepTicked();
    if (keep || none) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

}  // namespace plumb::editor::ui
