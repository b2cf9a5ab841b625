// The dialog that imports a file of Tiled, LDtk or Aseprite and shows a report.

#include "editor/ui/dialogs/import_dialog.hpp"

#include <imgui.h>

#include "core/text.hpp"
#include "editor/model/input/key_words.hpp"
#include "editor/ui/ui_compat.hpp"
#include "editor/ui/widgets/dialog.hpp"
#include "editor/ui/widgets/text_field.hpp"

namespace plumb::editor::ui {
namespace {

void line(ImU32 color, const std::string& where, const std::string& what, const std::string& remedy) {
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    ImGui::Bullet();
    ImGui::TextWrapped("%s%s%s", where.c_str(), where.empty() ? "" : ": ", what.c_str());
    ImGui::PopStyleColor();
    if (remedy.empty()) return;
    ImGui::Indent();
    ImGui::PushStyleColor(ImGuiCol_Text, palette::kTextDim);
    ImGui::TextWrapped("%s", remedy.c_str());
    ImGui::PopStyleColor();
    ImGui::Unindent();
}

}  // namespace

void openSceneOrSay(Ui& ui, const std::string& path) {
    Workspace& workspace = ui.workspace;
    if (workspace.unsaved()) {
        workspace.notice =
            format("Save the open scene first ({}), then open {}", keysFor(workspace, "file.save"), path);
        return;
    }
    static_cast<void>(workspace.open(path).ok());
    ui.viewReady = false;
}

void ImportDialog::begin(Ui& ui) {
    Workspace& workspace = ui.workspace;
    workspace.request = WindowRequest::None;
    if (!task_) task_.emplace(workspace.project.root);
    task_->again();
    const Path wanted = std::exchange(workspace.importFrom, {});
    task_->goTo(wanted.empty() ? task_->folder() : wanted);
    place_ = (wanted.empty() ? task_->folder() : wanted).generic_string();
    missing_.clear();
    ImGui::OpenPopup("Import");
}

void ImportDialog::draw(Ui& ui) {
    if (ui.workspace.request == WindowRequest::Import) begin(ui);
    if (!beginDialog(ui, "Import", {640.0f, 460.0f})) return;
    if (task_->report()) {
        drawReport(ui, *task_->report());
    } else {
        drawChooser(ui);
    }
    ImGui::EndPopup();
}

void ImportDialog::drawChooser(Ui& ui) {
    ImGui::TextDisabled("Tiled maps (.tmx, .tmj, .world), LDtk projects (.ldtk) and Aseprite sheets (.json)");
    if (ImGui::Button("Up")) task_->goUp(), place_ = task_->folder().generic_string();
    ui.widgets.mark("Import/up");
    tooltip("Go to the parent folder");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1.0f);
    if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
    if (textField("##place", place_, ImGuiInputTextFlags_EnterReturnsTrue) && !task_->goTo(place_))
        missing_ = format("{} does not exist", place_);
    ui.widgets.mark("Import/place", place_);
    drawList(ui);
    drawTarget(ui);
    dialogFoot(ui);
    const bool possible = !task_->kind().empty();
    ImGui::BeginDisabled(!possible);
    const bool wanted = defaultButton(ui, "Import", 110.0f, "Import/Import");
    ImGui::EndDisabled();
    ImGui::SameLine();
    if (footButton(ui, "Cancel", 110.0f, "Import/Cancel")) ImGui::CloseCurrentPopup();
    if (wanted && possible) import(ui);
}

void ImportDialog::drawList(Ui& ui) {
    beginChild("files", {0.0f, -ui.px(106.0f)}, true);
    if (task_->rows().empty())
        ImGui::TextDisabled("This folder contains no file that can be imported. Choose another one.");
    const std::string chosen = task_->file().filename().string();
    for (const ImportRow& row : std::vector{task_->rows()}) {
        ImGui::PushStyleColor(ImGuiCol_Text, row.folder ? palette::kTextDim : palette::kText);
        const bool pressed = ImGui::Selectable((row.folder ? row.name + "/" : row.name).c_str(),
                                               row.name == chosen, ImGuiSelectableFlags_AllowDoubleClick);
        ImGui::PopStyleColor();
        ui.widgets.mark("Import/" + row.name);
        if (!pressed) continue;
        task_->choose(row);
        missing_.clear();
        place_ = (task_->file().empty() ? task_->folder() : task_->file()).generic_string();
        if (!row.folder && ImGui::IsMouseDoubleClicked(0) && !task_->kind().empty()) import(ui);
    }
    ImGui::EndChild();
}

void ImportDialog::drawTarget(Ui& ui) {
    const bool none = task_->file().empty();
    const std::string text = !missing_.empty()           ? missing_
                             : !task_->problem().empty() ? task_->problem()
                             : none                      ? "Choose a file."
                             : task_->kind().empty()     ? "Files of this kind cannot be imported."
                             : task_->replaces() ? format("{}; replaces the existing file", task_->kind())
                                                 : std::string{task_->kind()};
    const bool bad = !missing_.empty() || !task_->problem().empty() || (!none && task_->kind().empty());
    ImGui::PushStyleColor(ImGuiCol_Text, bad                          ? palette::kError
                                         : !none && task_->replaces() ? palette::kWarning
                                                                      : palette::kTextDim);
    ImGui::TextWrapped("%s", text.c_str());
    ImGui::PopStyleColor();
    ui.widgets.mark("Import/message", text);
    if (none || task_->kind().empty()) return;
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("Import as");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1.0f);
    textField("##target", task_->target);
    ui.widgets.mark("Import/target", task_->target);
}

void ImportDialog::import(Ui& ui) {
    if (!task_->run()) return;
    ui.workspace.notice = format("Imported {}", task_->report()->summary());
    for (const Error& problem : task_->report()->problems) logWarning("Import", problem);
}

void ImportDialog::drawReport(Ui& ui, const ImportReport& report) {
    ImGui::TextWrapped("%s: %s", report.from.c_str(), report.summary().c_str());
    ui.widgets.mark("Import/summary", report.summary());
    const bool clean = report.problems.empty();
    ImGui::PushStyleColor(ImGuiCol_Text, clean ? palette::kPlay : palette::kWarning);
    ImGui::TextUnformatted(
        clean ? "Everything was imported."
              : format("{} differences from the original:", report.foldedProblems().size()).c_str());
    ImGui::PopStyleColor();
    beginChild("report", {0.0f, -ui.px(40.0f)}, true);
    for (const Error& problem : report.foldedProblems())
        line(palette::kWarning, problem.where, problem.what, problem.remedy);
    for (const std::string& note : report.notes) line(palette::kTextDim, "", note, "");
    if (const std::string keys = report.leftOut(); !keys.empty()) {
        line(palette::kTextDim, "", keys, "");
        std::string all;
        for (const std::string& key : report.editorKeys) all += (all.empty() ? "" : ", ") + key;
        tooltip(all);
    }
    ImGui::EndChild();
    dialogFoot(ui);
    if (endsWith(report.scene, ".scene.json")) {
        if (footButton(ui, "Open scene", 110.0f, "Import/Open")) {
            ImGui::CloseCurrentPopup();
            openSceneOrSay(ui, report.scene);
        }
        ImGui::SameLine();
    }
    if (footButton(ui, "Copy report", 110.0f, "Import/Copy")) ui.workspace.clipboard = report.text();
    tooltip("Copies the report to the clipboard as text");
    ImGui::SameLine();
    const bool again = footButton(ui, "Import more", 110.0f, "Import/Again");
    ImGui::SameLine();
    if (defaultButton(ui, "Close", 110.0f, "Import/Close")) ImGui::CloseCurrentPopup();
    if (again) task_->again();
}

}  // namespace plumb::editor::ui
