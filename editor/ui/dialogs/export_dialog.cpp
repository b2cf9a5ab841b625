#include "editor/ui/dialogs/export_dialog.hpp"

#include <imgui.h>

#include "core/log.hpp"
#include "core/text.hpp"
#include "editor/ui/ui_compat.hpp"
#include "editor/ui/widgets/dialog.hpp"
#include "editor/ui/widgets/text_field.hpp"

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
        if (folder_.empty()) folder_ = ExportTask::folderBeside(workspace.project.root);
        if (!task_.running()) report_.clear();
        ImGui::OpenPopup(kTitle);
    }
    if (!beginDialog(ui, kTitle, {560.0f, 260.0f})) return;
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
    ImGui::TextDisabled("Folder of the exported game, which runs without the editor");
    if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
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
    if (done && !trimmed(folder_).empty())
        task_.start(workspace.program, workspace.project.root, std::string{trimmed(folder_)});
}

void ExportDialog::drawResult(Ui& ui) {
    beginChild("report", {0.0f, -ui.px(40.0f)}, true);
    ImGui::PushStyleColor(ImGuiCol_Text, !task_.running() && failed_ ? palette::kError : palette::kText);
    ImGui::TextWrapped("%s", task_.running() ? "Exporting..." : report_.c_str());
    ImGui::PopStyleColor();
    ImGui::EndChild();
    ui.widgets.mark("Export/report", task_.running() ? "" : report_);
    dialogFoot(ui);
    if (defaultButton(ui, "Close", 110.0f, "Export/Close")) ImGui::CloseCurrentPopup();
}

}  // namespace plumb::editor::ui
