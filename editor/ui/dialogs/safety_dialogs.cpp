#include "editor/ui/dialogs/safety_dialogs.hpp"

#include <algorithm>
#include <utility>

#include "core/text.hpp"
#include "editor/model/safety/save_beside.hpp"
#include "editor/model/safety/scene_differences.hpp"
#include "editor/ui/ui_compat.hpp"

namespace plumb::editor::ui {
namespace {

constexpr const char* kRecovery = "Work that was not saved";
constexpr const char* kChanged = "Changed by another program";
constexpr const char* kBackups = "Backups of this scene";
constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove;

void centerNext(ImVec2 size) {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({(display.x - size.x) * 0.5f, (display.y - size.y) * 0.4f});
    ImGui::SetNextWindowSize(size);
}

constexpr float kListHeight = 190.0f;  // px at scale 1, of differences

bool accentButton(const char* label, ImVec2 size) {
    ImGui::PushStyleColor(ImGuiCol_Button, palette::kAccentSoft);
    const bool pressed = ImGui::Button(label, size);
    ImGui::PopStyleColor();
    return pressed;
}

}  // namespace

void SafetyDialogs::draw(Ui& ui) {
    ask(ui);
    drawRecovery(ui);
    drawChanged(ui);
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
        // Displaced by another dialog it comes back after that; closed by Esc it waits.
        if (!anyPopupOpen()) {
            if (closed == Question::Recovery) later_ = true;
            if (closed == Question::Changed) {
                waits_ = true;
                ui.workspace.notice =
                    format("{} was changed by another program; saving asks which one to keep",
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
    const ImVec2 size{ui.px(440.0f), ui.px(360.0f)};
    centerNext(size);
    if (!ImGui::BeginPopupModal(kBackups, nullptr, kFixed)) return;
    if (backups_.empty()) {
        ImGui::TextWrapped(
            "There are none yet. Each save keeps the file as it was before, the last %d of them.",
            static_cast<int>(Backups::kCopies));
    } else {
        ImGui::TextDisabled("Opens as it was then, not saved. What you have now becomes a backup too.");
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
    if (ImGui::Button("Cancel", {ui.px(110.0f), 0.0f})) ImGui::CloseCurrentPopup();
    ui.widgets.mark("Backups/cancel");
    ImGui::EndPopup();
}

void SafetyDialogs::drawRecovery(Ui& ui) {
    SafetyNet& safety = ui.workspace.safety;
    if (open_ != Question::Recovery) return;
    const float rows = std::min(static_cast<float>(safety.lost().size()), 6.0f);
    const float list = differences_.empty() ? 0.0f : kListHeight;
    const ImVec2 size{ui.px(620.0f), ui.px(150.0f + 34.0f * rows + list)};
    centerNext(size);
    if (!ImGui::BeginPopupModal(kRecovery, nullptr, kFixed)) return;
    ImGui::TextWrapped(
        "The editor ended without saving. The files are as you saved them last; this is newer:");
    ImGui::Spacing();
    beginChild("lost", {0.0f, -ui.px(40.0f + list)}, false);
    for (std::size_t i = 0; i < safety.lost().size(); ++i) {
        const LostWork& work = safety.lost()[i];
        ImGui::PushID(static_cast<int>(i));
        ImGui::AlignTextToFramePadding();
        ImGui::TextUnformatted(work.scene.c_str());
        ui.widgets.mark(format("Recovery/{}", i), work.scene);
        ImGui::SameLine(ui.px(250.0f));
        ImGui::TextDisabled("%s", work.when.c_str());
        const ImVec2 button{ui.px(84.0f), 0.0f};
        const ImVec2 wide{ui.px(104.0f), 0.0f};
        ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - 2.0f * button.x - wide.x - ui.px(16.0f));
        if (ImGui::Button("Look at both", wide)) {
            const Result<std::string> file = readFile(ui.workspace.project.root / work.scene);
            compare(file ? *file : std::string{}, work.text);
        }
        ui.widgets.mark(format("Recovery/{}/look", i));
        tooltip("Lists what differs from the file.");
        ImGui::SameLine(0.0f, ui.px(8.0f));
        const bool recover = accentButton("Recover", button);
        ui.widgets.mark(format("Recovery/{}/recover", i));
        tooltip("Opens it as it was, not saved; the file stays until you save.");
        ImGui::SameLine(0.0f, ui.px(8.0f));
        const bool discard = ImGui::Button("Discard", button);
        ui.widgets.mark(format("Recovery/{}/discard", i));
        tooltip("Goes to the backups of the scene.");
        ImGui::PopID();
        if (recover || discard) {
            if (discard) safety.discard(i);
            if (const Result<Done> done = recover ? safety.recover(i) : Done{}; !done)
                ui.workspace.notice = done.error().text();
            if (recover) ui.viewReady = false;
            differences_.clear();
            break;
        }
    }
    ImGui::EndChild();
    drawDifferences(ui, "Recovery/differences");
    if (ImGui::Button("Later", {ui.px(110.0f), 0.0f})) later_ = true;
    ui.widgets.mark("Recovery/later");
    tooltip("Asks again when the project is opened the next time.");
    if (later_ || safety.lost().empty()) {
        differences_.clear();
        open_ = Question::None;
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
}

void SafetyDialogs::drawChanged(Ui& ui) {
    Workspace& workspace = ui.workspace;
    if (open_ != Question::Changed) return;
    const ImVec2 size{ui.px(580.0f), ui.px(170.0f + (differences_.empty() ? 0.0f : kListHeight))};
    centerNext(size);
    if (!ImGui::BeginPopupModal(kChanged, nullptr, kFixed)) return;
    ImGui::TextWrapped("%s was changed on the disk since you opened or saved it.",
                       workspace.document.scenePath.c_str());
    ImGui::Spacing();
    ImGui::TextDisabled("%s", workspace.unsaved()
                                  ? "You have changes too that are not saved. Whichever you choose, the other"
                                  : "You have changed nothing since. Whichever you choose, the other");
    ImGui::TextDisabled("one stays among the backups.");
    drawDifferences(ui, "Changed/differences");
    ImGui::SetCursorPosY(size.y - ui.px(40.0f));
    const ImVec2 button{ui.px(130.0f), 0.0f};
    const bool theirs = accentButton("Load theirs", button);
    ui.widgets.mark("Changed/theirs");
    ImGui::SameLine();
    const bool mine = ImGui::Button("Keep mine", button);
    ui.widgets.mark("Changed/mine");
    ImGui::SameLine();
    bool beside = ImGui::Button("Save mine beside", button);
    ui.widgets.mark("Changed/beside");
    tooltip("Yours becomes a scene of its own; here is theirs.");
    ImGui::SameLine();
    if (ImGui::Button("Compare", button)) {
        const Result<std::string> file = readFile(workspace.project.root / workspace.document.scenePath);
        compare(workspace.text(), file ? *file : std::string{});
    }
    ui.widgets.mark("Changed/compare");
    tooltip("Lists what theirs has that yours has not.");
    if (beside) {
        const Result<Path> file = saveBeside(workspace);
        if (file) workspace.safety.takeTheirs();
        beside = file.ok();
        workspace.notice =
            file ? format("Yours is in {}; this is theirs", file->filename().string()) : file.error().text();
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
