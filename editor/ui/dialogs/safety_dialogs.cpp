#include "editor/ui/dialogs/safety_dialogs.hpp"

#include <algorithm>
#include <utility>

#include "core/text.hpp"
#include "editor/model/problems.hpp"
#include "editor/model/safety/save_beside.hpp"
#include "editor/model/safety/scene_differences.hpp"
#include "editor/ui/ui_compat.hpp"
#include "editor/ui/widgets/fitted_text.hpp"

namespace plumb::editor::ui {
namespace {

constexpr const char* kRecovery = "Recover unsaved changes";
constexpr const char* kChanged = "Changed by another program";
constexpr const char* kBackups = "Backups of this scene";
constexpr const char* kNotSaved = "Not saved";

constexpr const char* kAsksAgain =
    "The unsaved changes are kept; the editor asks again when the project is next opened";
constexpr float kLostName = 200.0f;     // px at scale 1: width of the name of a scene
constexpr float kLostButtons = 400.0f;  // px at scale 1: x of the buttons of a row
constexpr float kListHeight = 190.0f;   // px at scale 1: height of the list of differences

}  // namespace

void SafetyDialogs::draw(Ui& ui) {
    ask(ui);
    drawRecovery(ui);
    drawChanged(ui);
    drawNotSaved(ui);
    drawBackups(ui);
}

SafetyDialogs::Question SafetyDialogs::nextQuestion(Ui& ui) const {
    const SafetyNet& safety = ui.workspace.safety;
    if (!safety.lost().empty() && !later_) return Question::Recovery;
    const bool changed = safety.onDisk() == FileWatch::State::Changed;
    const bool disturbs = ui.workspace.play.running() && !refused_;
    return changed && !waits_ && !disturbs ? Question::Changed : Question::None;
}

void SafetyDialogs::ask(Ui& ui) {
    SafetyNet& safety = ui.workspace.safety;
    if (safety.onDisk() != FileWatch::State::Changed) waits_ = refused_ = false;
    if (safety.takeRefusal()) refused_ = true, waits_ = false;
    const auto title = [](Question question) {
        return question == Question::Recovery ? kRecovery : kChanged;
    };
    if (open_ != Question::None && !ImGui::IsPopupOpen(title(open_))) {
        const Question closed = std::exchange(open_, Question::None);
        differences_.clear();
        // If another dialog replaced the question, the question opens again after that dialog; if the user
        // closed the question with Esc, it is postponed.
        if (!anyPopupOpen()) {
            if (closed == Question::Recovery) {
                later_ = true;
                ui.workspace.notice = kAsksAgain;
            }
            if (closed == Question::Changed) {
                waits_ = true;
                ui.workspace.notice =
                    format("{} was changed by another program; saving asks which version to keep",
                           ui.workspace.document.scenePath);
            }
        }
    }
    if (anyPopupOpen()) return;
    open_ = nextQuestion(ui);
    if (open_ != Question::None) ImGui::OpenPopup(title(open_));
}

void SafetyDialogs::compare(std::string_view file, std::string_view other) {
    differences_ = sceneDifferences(file, other);
}

void SafetyDialogs::drawDifferences(Ui& ui, const char* path) const {
    if (differences_.empty()) return;
    beginChild(path, {0.0f, ui.px(kListHeight - 10.0f)}, true);
    for (const std::string& line : differences_) ImGui::TextUnformatted(line.c_str());
    ImGui::EndChild();
    ui.widgets.mark(path, differences_.front());
}

void SafetyDialogs::chooseBackup(Ui& ui) {
    backups_ = ui.workspace.safety.backups.of(ui.workspace.document.scenePath);
    ImGui::OpenPopup(kBackups);
}

void SafetyDialogs::drawBackups(Ui& ui) {
    if (!beginDialog(ui, kBackups, {440.0f, 360.0f})) return;
    if (backups_.empty()) {
        ImGui::TextWrapped(
            "This scene has no backups. Each save backs up the previous file; the last %d backups are kept.",
            static_cast<int>(Backups::kCopies));
    } else {
        ImGui::TextDisabled("Click a version to open it; unsaved changes are backed up first.");
    }
    beginChild("backups", {0.0f, -ui.px(40.0f)}, false);
    for (std::size_t i = 0; i < backups_.size(); ++i) {
        const Backup& backup = backups_[i];
        const bool chosen = ImGui::Selectable(format("{}##{}", backup.when, i).c_str());
        ui.widgets.mark(format("Backups/{}", i), backup.when);
        ImGui::SameLine(ui.px(220.0f));
        ImGui::TextDisabled("%s KB", fixedText(static_cast<double>(backup.bytes) / 1024.0, 1).c_str());
        if (!chosen) continue;
        ImGui::CloseCurrentPopup();
        if (const Result<Done> opened = ui.workspace.safety.restore(backup); !opened)
            ui.workspace.notice = opened.error().text();
        ui.viewReady = false;
    }
    ImGui::EndChild();
    if (defaultButton(ui, "Cancel", 110.0f, "Backups/cancel")) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

/// Draws the row of one unsaved scene. @return true if it was recovered or discarded, which removes it from
/// the list
bool SafetyDialogs::drawLost(Ui& ui, std::size_t index) {
    SafetyNet& safety = ui.workspace.safety;
    const LostWork& work = safety.lost()[index];
    // The list is sorted newest first; further versions of the same scene are marked as older.
    const bool older =
        std::any_of(safety.lost().begin(), safety.lost().begin() + static_cast<std::ptrdiff_t>(index),
                    [&](const LostWork& other) { return other.scene == work.scene; });
    const std::string name = format("Recovery/{}", index);
    ImGui::PushID(static_cast<int>(index));
    ImGui::AlignTextToFramePadding();
    fittedLine(work.scene, ui.px(kLostName));
    ui.widgets.mark(name, work.scene);
    ImGui::SameLine(ui.px(kLostName + 10.0f));
    const std::string when = older ? work.when + ", older" : work.when;
    ImGui::TextDisabled("%s", when.c_str());
    ui.widgets.mark(name + "/when", when);
    ImGui::SameLine(ui.px(kLostButtons));
    if (footButton(ui, "Compare", 104.0f, name + "/look")) {
        const Result<std::string> file = readFile(ui.workspace.project.root / work.scene);
        compare(file ? *file : std::string{}, work.text);
    }
    tooltip("Lists the differences from the saved file");
    ImGui::SameLine();
    const bool recover = footButton(ui, "Recover", 84.0f, name + "/recover", palette::kAccentSoft);
    tooltip("Opens this version unsaved; the file is not changed until you save");
    ImGui::SameLine();
    const bool discard = footButton(ui, "Discard", 84.0f, name + "/discard");
    tooltip("Moves this version to the backups of the scene");
    ImGui::PopID();
    if (!recover && !discard) return false;
    if (discard) safety.discard(index);
    if (const Result<Done> done = recover ? safety.recover(index) : Done{}; !done)
        ui.workspace.notice = done.error().text();
    if (recover) ui.viewReady = false;
    differences_.clear();
    return true;
}

void SafetyDialogs::drawRecovery(Ui& ui) {
    SafetyNet& safety = ui.workspace.safety;
    if (open_ != Question::Recovery) return;
    const float rows = std::min(static_cast<float>(safety.lost().size()), 6.0f);
    const float list = differences_.empty() ? 0.0f : kListHeight;
    if (!beginDialog(ui, kRecovery, {kLostButtons + 320.0f, 150.0f + 34.0f * rows + list})) return;
    ImGui::TextWrapped(
        "The editor ended without saving. These scenes have changes that are newer than the saved files:");
    ImGui::Spacing();
    beginChild("lost", {0.0f, -ui.px(40.0f + list)}, false);
    for (std::size_t i = 0; i < safety.lost().size(); ++i) {
        if (drawLost(ui, i)) break;
    }
    ImGui::EndChild();
    drawDifferences(ui, "Recovery/differences");
    if (defaultButton(ui, "Later", 110.0f, "Recovery/later")) {
        later_ = true;
        ui.workspace.notice = kAsksAgain;
    }
    tooltip("Asks again when the project is next opened");
    if (later_ || safety.lost().empty()) {
        differences_.clear();
        open_ = Question::None;
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
}

/// Shows a dialog after a save failed because of the disk; a notice in the status bar could be missed.
void SafetyDialogs::drawNotSaved(Ui& ui) {
    Workspace& workspace = ui.workspace;
    std::string& problem = problemsOf(workspace).save;
    const bool asked = !problem.empty();
    if (notSaved_.ask(asked)) problem.clear();
    if (!beginDialog(ui, kNotSaved, {460.0f, 180.0f})) return;
    ImGui::TextWrapped("The scene could not be saved; the file is unchanged.");
    ImGui::Spacing();
    ImGui::PushStyleColor(ImGuiCol_Text, palette::kError);
    ImGui::TextWrapped("%s", problem.c_str());
    ImGui::PopStyleColor();
    ui.widgets.mark("NotSaved/problem", problem);
    dialogFoot(ui);
    const bool again = defaultButton(ui, "Try again", 110.0f, "NotSaved/again");
    ImGui::SameLine();
    const bool close = footButton(ui, "Close", 110.0f, "NotSaved/close");
    if (again) static_cast<void>(workspace.save().ok());
    if (close) problem.clear();
    if (problem.empty()) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

void SafetyDialogs::drawChanged(Ui& ui) {
    Workspace& workspace = ui.workspace;
    if (open_ != Question::Changed) return;
    if (!beginDialog(ui, kChanged, {580.0f, 170.0f + (differences_.empty() ? 0.0f : kListHeight)})) return;
    ImGui::TextWrapped("Another program changed %s since you opened or saved it.",
                       workspace.document.scenePath.c_str());
    ImGui::Spacing();
    ImGui::PushStyleColor(ImGuiCol_Text, palette::kTextDim);
    ImGui::TextWrapped(
        "%s Whichever version you choose, the other one is added to the backups.",
        workspace.unsaved() ? "You have unsaved changes, too." : "You have no unsaved changes.");
    ImGui::PopStyleColor();
    drawDifferences(ui, "Changed/differences");
    dialogFoot(ui);
    const bool theirs = footButton(ui, "Load theirs", 130.0f, "Changed/theirs", palette::kAccentSoft);
    ImGui::SameLine();
    const bool mine = footButton(ui, "Keep mine", 130.0f, "Changed/mine");
    ImGui::SameLine();
    bool beside = footButton(ui, "Save mine as copy", 130.0f, "Changed/beside");
    tooltip("Saves your version as a new scene, and opens the other program's version");
    ImGui::SameLine();
    if (footButton(ui, "Compare", 130.0f, "Changed/compare")) {
        const Result<std::string> file = readFile(workspace.project.root / workspace.document.scenePath);
        compare(workspace.text(), file ? *file : std::string{});
    }
    tooltip("Lists how the other program's version differs from yours");
    if (beside) {
        const Result<Path> file = saveBeside(workspace);
        if (file) workspace.safety.takeTheirs();
        beside = file.ok();
        workspace.notice =
            file ? format("Saved your version as {}; the other program's is open", file->filename().string())
                 : file.error().text();
    }
    if (theirs) workspace.safety.takeTheirs();
    if (mine) workspace.safety.keepMine();
    if (theirs || mine || beside) {
        differences_.clear();
        open_ = Question::None;
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
}

}  // namespace plumb::editor::ui
