#include "editor/ui/dialogs/export_dialog.hpp"

#include <cstddef>
#include <span>

#include <imgui.h>

#include "core/log.hpp"
#include "core/text.hpp"
#include "editor/ui/ui_compat.hpp"
#include "editor/ui/widgets/dialog.hpp"
#include "editor/ui/widgets/text_field.hpp"
#include "platform/open_file.hpp"

namespace plumb::editor::ui {
namespace {

constexpr const char* kTitle = "Export";

/// Returns the last line, which says how the export ended.
std::string lastLine(std::string_view text) {
    const std::string_view whole = trimmed(text);
    return std::string{whole.substr(whole.rfind('\n') + 1)};  // no line break: npos + 1 is the start
}

}  // namespace

void ExportDialog::draw(Ui& ui) {
    Workspace& workspace = ui.workspace;
    poll(ui);
    if (workspace.request == WindowRequest::Export) {
        workspace.request = WindowRequest::None;
        if (folder_.empty()) folder_ = exportFolder(workspace.project.root, target());
        if (!task_.running()) report_.clear();
        ImGui::OpenPopup(kTitle);
    }
    if (!beginDialog(ui, kTitle, {620.0f, 340.0f})) return;
    task_.running() || !report_.empty() ? drawResult(ui) : drawQuestion(ui);
    ImGui::EndPopup();
}

void ExportDialog::poll(Ui& ui) {
    const std::optional<ProgramEnd> end = task_.poll();
    if (!end) return;
    report_ = end->text.empty() ? "The export ended without a message." : end->text;
    failed_ = !end->succeeded;
    ui.workspace.notice = lastLine(report_);
    if (failed_) {
        logError("Export", Error{folder_, lastLine(report_), "see the messages before it, and export again"});
    } else {
        logNote("Export", "{}", ui.workspace.notice);
    }
}

void ExportDialog::drawQuestion(Ui& ui) {
    Workspace& workspace = ui.workspace;
    const bool appears = ImGui::IsWindowAppearing();
    drawTargets(ui);
    ImGui::Spacing();
    ImGui::TextDisabled("%s", "Folder of the exported game, which runs without the editor");
    if (appears) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(-1.0f);
    bool done = textField("##folder", folder_, ImGuiInputTextFlags_EnterReturnsTrue);
    ui.widgets.mark("Export/folder", folder_);
    ImGui::PushStyleColor(ImGuiCol_Text, workspace.unsaved() ? palette::kWarning : palette::kTextDim);
    ImGui::TextWrapped("%s", workspace.unsaved()
                                 ? "The open scene has unsaved changes; they are not part of the export."
                                 : "All scenes and the code are checked first.");
    ImGui::PopStyleColor();
    dialogFoot(ui);
    done |= defaultButton(ui, "Export", 110.0f, "Export/Export");
    ImGui::SameLine();
    if (footButton(ui, "Cancel", 110.0f, "Export/Cancel")) ImGui::CloseCurrentPopup();
    if (done && !trimmed(folder_).empty()) start(ui);
}

void ExportDialog::drawTargets(Ui& ui) {
    const Path& project = ui.workspace.project.root;
    const bool canBuild = !plumbScript(ui.workspace.program).empty();
    if (!canBuild) target_ = 0;
    ImGui::TextDisabled("%s", "For");
    ImGui::SetNextItemWidth(-1.0f);
    const bool open = ImGui::BeginCombo("##target", target().label);
    ui.widgets.mark("Export/target", target().label);
    if (open) {
        const std::span<const ExportTarget> all = exportTargets();
        for (std::size_t i = 0; i < (canBuild ? all.size() : 1); ++i) {
            if (ImGui::Selectable(all[i].label, i == target_)) {
                if (folder_ == exportFolder(project, target())) folder_ = exportFolder(project, all[i]);
                target_ = i;
            }
            ui.widgets.mark(format("Export/target/{}", all[i].label));
        }
        ImGui::EndCombo();
    }
    ImGui::PushStyleColor(ImGuiCol_Text, palette::kTextDim);
    ImGui::TextWrapped("%s%s", target().text,
                       !canBuild      ? " For other systems, export with ./plumb in the engine's sources."
                       : target_ == 0 ? ""
                                      : " The first time, the player is built, which takes some minutes.");
    ImGui::PopStyleColor();
}

void ExportDialog::start(Ui& ui) {
    folder_ = trimmed(folder_);
    started_ = ImGui::GetTime();
    task_.start(ui.workspace.program, ui.workspace.project.root, target(), folder_);
}

void ExportDialog::drawResult(Ui& ui) {
    const bool running = task_.running();
    if (running) {
        const int seconds = static_cast<int>(ImGui::GetTime() - started_);
        ImGui::Text("Exporting for: %s, %d:%02d", target().label, seconds / 60, seconds % 60);
    } else {
        ImGui::TextColored(ImColor{failed_ ? palette::kError : palette::kText}, "%s",
                           failed_ ? "The export failed" : "Exported");
    }
    beginChild("report", {0.0f, -ui.px(40.0f)}, true);
    ImGui::PushStyleColor(ImGuiCol_Text, !running && failed_ ? palette::kError : palette::kText);
    ImGui::TextWrapped("%s", running ? task_.text().c_str() : report_.c_str());
    ImGui::PopStyleColor();
    if (running) ImGui::SetScrollHereY(1.0f);
    ImGui::EndChild();
    ui.widgets.mark("Export/report", running ? "" : report_);
    dialogFoot(ui);
    if (defaultButton(ui, "Close", 110.0f, "Export/Close")) ImGui::CloseCurrentPopup();
    ImGui::SameLine();
    if (running) {
        if (footButton(ui, "Stop", 110.0f, "Export/Stop")) task_.stop();
    } else if (!failed_ && footButton(ui, "Open folder", 130.0f, "Export/Open folder")) {
        openFolder(ui);
    }
}

void ExportDialog::openFolder(Ui& ui) {
    const Result<Done> opened = openFile(folder_);
    if (!opened) ui.workspace.notice = opened.error().text();
}

}  // namespace plumb::editor::ui
