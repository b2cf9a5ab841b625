// The status bar and the dialogs of EditorWindow; its other functions are in editor_window.cpp.

#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "editor/model/actions.hpp"
#include "editor/model/input/key_words.hpp"
#include "editor/model/prefabs/prefab_visit.hpp"
#include "editor/model/problems.hpp"
#include "editor/ui/editor_window.hpp"
#include "editor/ui/panels/log_counts.hpp"
#include "editor/ui/ui_compat.hpp"
#include "editor/ui/widgets/bar.hpp"
#include "editor/ui/widgets/dialog.hpp"
#include "editor/ui/widgets/fitted_text.hpp"

namespace plumb::editor::ui {
namespace {

/// If an action set no notice, sets one with the label of the action's undo step: "Did: LABEL".
void tellStep(Workspace& workspace) {
    // The state of the last frame (number of steps, hash of the notice, ...) is kept in ImGui's storage.
    ImGuiStorage& storage = *ImGui::GetStateStorage();
    const auto idOf = [](const std::string& text) { return static_cast<int>(ImGui::GetID(text.c_str())); };
    const auto kept = [&](const char* name) { return storage.GetInt(ImGui::GetID(name)); };
    const auto keep = [&](const char* name, int value) { storage.SetInt(ImGui::GetID(name), value); };
    const UndoStack& undo = workspace.undo;
    std::string& notice = workspace.notice;
    const int steps = static_cast<int>(undo.size());
    const int cleared = static_cast<int>(undo.cleared());
    const bool made = steps > kept("steps") && cleared == kept("cleared");
    const bool silent = idOf(notice) == kept("notice");
    const std::string label = made ? undo.label(undo.size() - 1) : std::string{};
    // The hint of a tile tool must not be replaced by the label of a stroke.
    const ToolRow& tool = toolTable()[workspace.toolIndex()];
    const bool hint = tool.forTiles && notice == format("{}: {}", tool.name, withKeys(workspace, tool.hint));
    if (made && silent && !hint && idOf(label) != kept("step")) {
        const std::string& subject = undo.subject(undo.size() - 1);
        const bool named =
            subject.empty() || label.find(subject) != std::string::npos || endsWith(subject, " more");
        notice = named ? format("Did: {}", label) : format("Did: {} ({})", label, subject);
    } else if (silent && steps < kept("steps") && startsWith(notice, "Did: ")) {
        notice.clear();  // the step was undone
    }
    if (idOf(notice) != kept("notice")) keep("step", idOf(label));
    keep("notice", idOf(notice));
    keep("steps", steps);
    keep("cleared", cleared);
}

}  // namespace

/// Returns mouse position, selection, zoom and saved state as text; leaves out what exceeds `width`, px.
std::string EditorWindow::stateInWords(float width) const {
    const Document& document = workspace_.document;
    if (document.scenePath.empty()) return "No scene";
    const std::string saved = workspace_.unsaved() ? "Not saved" : "Saved";
    const std::string zoom = format("{}%", std::lround(workspace_.view.zoom() * 100.0f));
    const std::string selected =
        format("{} of {} selected", document.selection.size(), document.objectCount());
    std::vector<std::string> parts{selected, zoom, saved};
    if (ui_.mouseOverScene)
        parts.insert(parts.begin(),
                     format("{}, {}", std::lround(ui_.mouseInScene.x), std::lround(ui_.mouseInScene.y)));
    std::string words;
    do {
        words.clear();
        for (const std::string& part : parts) words += (words.empty() ? "" : "    ") + part;
        parts.erase(parts.begin());
    } while (!parts.empty() && ImGui::CalcTextSize(words.c_str()).x > width);
    return words;
}

/// Returns the last notice, or the hint of the active tool; while a game runs, preceded by the tick.
std::string EditorWindow::noticeInWords() const {
    const std::string& notice = workspace_.notice;
    if (!workspace_.play.running())
        return notice.empty() ? withKeys(workspace_, toolTable()[workspace_.toolIndex()].hint) : notice;
    const std::string tick =
        format("{} - tick {}", workspace_.play.paused() ? "Paused" : "Playing", workspace_.play.ticks());
    return notice.empty() || notice == kPlayingNotice ? tick : format("{}    {}", tick, notice);
}

void EditorWindow::drawStatus(float height) {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    beginBar(ui_, "status", {0.0f, display.y - height}, {display.x, height}, {ui_.px(10.0f), ui_.px(4.0f)});
    tellStep(workspace_);
    const float gap = ui_.px(22.0f);
    const std::string right = stateInWords(display.x * 0.6f);
    const float place = display.x - ImGui::CalcTextSize(right.c_str()).x - ui_.px(10.0f);
    const float log = logCountsWidth(ui_);
    const std::string left = noticeInWords();
    ImGui::PushStyleColor(ImGuiCol_Text, palette::kTextDim);
    fittedLine(left, place - ui_.px(10.0f) - gap - (log > 0.0f ? log + gap : 0.0f));
    ImGui::PopStyleColor();
    widgets_.mark("Status/notice", left);
    if (place - ImGui::GetItemRectMax().x > log + 2.0f * gap - 1.0f) drawLogCounts(ui_);
    ImGui::SameLine(place);
    ImGui::TextDisabled("%s", right.c_str());
    widgets_.mark("Status/state", right);
    ImGui::End();
}

void EditorWindow::openScene(const std::string& path) {
    static_cast<void>(workspace_.open(path).ok());
    ui_.viewReady = false;
}

void EditorWindow::drawDialogs() {
    switch (workspace_.request) {
        case WindowRequest::ChooseBackup:
            safety_.chooseBackup(ui_);
            workspace_.request = WindowRequest::None;
            break;
        case WindowRequest::Quit:
            workspace_.request = WindowRequest::None;
            leaveFor([this] { quit_ = true; });
            break;
        case WindowRequest::NameLayout:
            layoutMenu_.askName();
            workspace_.request = WindowRequest::None;
            break;
        case WindowRequest::LargerText:
        case WindowRequest::SmallerText:
            // applyLook() takes effect at the start of the next frame.
            workspace_.settings.scale += workspace_.request == WindowRequest::LargerText ? 0.125f : -0.125f;
            workspace_.settings.scale =
                std::clamp(workspace_.settings.scale, Settings::kLeastScale, Settings::kMostScale);
            workspace_.request = WindowRequest::None;
            break;
        case WindowRequest::Preferences:
            preferences_.open();
            workspace_.request = WindowRequest::None;
            break;
        case WindowRequest::Welcome:
            workspace_.stopPlaying();
            welcome_.open(ui_);
            workspace_.request = WindowRequest::None;
            break;
        case WindowRequest::OpenProject:
            workspace_.request = WindowRequest::None;
            leaveFor([this] { project_ = std::exchange(workspace_.projectToOpen, {}); });
            break;
        case WindowRequest::None:
        case WindowRequest::ChooseScene:
        case WindowRequest::NameNewScene:
        case WindowRequest::NameSceneCopy:
        case WindowRequest::Export:
        case WindowRequest::ChoosePrefab:
        case WindowRequest::Import:
        case WindowRequest::FindFile:
        case WindowRequest::FindCommand:
        case WindowRequest::NamePrefab:
        case WindowRequest::ShowOverrides:
        case WindowRequest::RenameSelected: break;
    }
    if (const auto visit = takePrefabVisit(workspace_)) leaveFor([this, visit] { go(workspace_, *visit); });
    drawSceneName();
    if (std::exchange(askUnsaved_, false)) ImGui::OpenPopup("Unsaved changes");
    drawUnsaved();
    keep_.draw(ui_);
    prefabDialogs_.draw(ui_);
    safety_.draw(ui_);
    import_.draw(ui_);
    export_.draw(ui_);
    if (const std::string scene = finder_.draw(ui_); !scene.empty())
        leaveFor([=, this] { openScene(scene); });
    layoutMenu_.drawQuestion(ui_);
    preferences_.draw(ui_);
}

void EditorWindow::leaveFor(std::function<void()> next) {
    if (!workspace_.unsaved()) return next();
    next_ = std::move(next);
    unsavedProblem_.clear();
    askUnsaved_ = true;
}

void EditorWindow::drawSceneName() {
    const std::optional<SceneNameDialog::Answer> answer = sceneName_.draw(ui_);
    if (!answer) return;
    const auto report = [this](const Result<Done>& done) {
        if (!done) workspace_.notice = done.error().text();
    };
    if (answer->copy) return report(workspace_.saveAs(answer->name));
    leaveFor([this, report, name = answer->name] {
        report(workspace_.createScene(name));
        ui_.viewReady = false;
    });
}

void EditorWindow::drawUnsaved() {
    if (!beginDialog(ui_, "Unsaved changes", {400.0f, unsavedProblem_.empty() ? 140.0f : 190.0f})) return;
    ImGui::TextWrapped("%s has unsaved changes.", workspace_.document.scenePath.c_str());
    if (!unsavedProblem_.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, palette::kError);
        ImGui::TextWrapped("%s", unsavedProblem_.c_str());
        ImGui::PopStyleColor();
        widgets_.mark("Unsaved/problem", unsavedProblem_);
    }
    dialogFoot(ui_);
    const auto leave = [&] {
        ImGui::CloseCurrentPopup();
        next_();
    };
    if (defaultButton(ui_, "Save", 110.0f, "Unsaved/Save")) {
        if (const Result<Done> saved = workspace_.save(); saved) {
            leave();
        } else if (workspace_.safety.onDisk() == FileWatch::State::Changed) {
            ImGui::CloseCurrentPopup();  // another dialog first asks which version to keep
        } else {
            unsavedProblem_ = saved.error().text();
            problemsOf(workspace_).save.clear();  // the error is shown in this dialog
        }
    }
    ImGui::SameLine();
    if (footButton(ui_, "Discard", 110.0f, "Unsaved/Discard")) leave();
    ImGui::SameLine();
    if (footButton(ui_, "Cancel", 110.0f, "Unsaved/Cancel")) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

}  // namespace plumb::editor::ui
