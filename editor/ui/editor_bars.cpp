// The bars of the window and its questions; the rest is in editor_window.cpp.

#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "editor/model/actions.hpp"
#include "editor/model/key_words.hpp"
#include "editor/model/prefab_visit.hpp"
#include "editor/ui/editor_window.hpp"
#include "editor/ui/icons.hpp"
#include "editor/ui/overlays/overlay_list.hpp"
#include "editor/ui/ui_compat.hpp"
#include "editor/ui/widgets/list_arrow.hpp"
#include "editor/ui/widgets/snap_menu.hpp"

namespace plumb::editor::ui {
namespace {

constexpr ImGuiWindowFlags kBar = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                  ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus;

constexpr float kButtonSide = 28.0f;  // px at scale 1; all that stands in the toolbar is as high

ImU32 chromeOf(const PlayMode& play) {
    if (!play.running()) return palette::kChrome;
    return play.paused() ? palette::kChromePaused : palette::kChromePlaying;
}

void beginBar(const char* name, ImVec2 at, ImVec2 size, ImVec2 padding, ImU32 color) {
    ImGui::SetNextWindowPos(at);
    ImGui::SetNextWindowSize(size);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1.0f, 1.0f});
    ImGui::PushStyleColor(ImGuiCol_WindowBg, color);
    ImGui::Begin(name, nullptr, kBar);
    ImGui::PopStyleColor();
    ImGui::PopStyleVar(2);
}

/// What was done without a word of its own is told by its step of undo.
void tellStep(Workspace& workspace) {
    // As the bar showed it last: how many steps there were, and what told of which.
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
    // How a tile tool is used is worth more than that it was.
    const ToolRow& tool = toolTable()[workspace.toolIndex()];
    const bool hint = tool.forTiles && notice == format("{}: {}", tool.name, withKeys(workspace, tool.hint));
    if (made && silent && !hint && idOf(label) != kept("step")) {
        const std::string& whom = undo.subject(undo.size() - 1);
        const bool named = whom.empty() || label.find(whom) != std::string::npos || endsWith(whom, " more");
        notice = named ? format("Did: {}", label) : format("Did: {} ({})", label, whom);
    } else if (silent && steps < kept("steps") && startsWith(notice, "Did: ")) {
        notice.clear();  // it was taken back
    }
    if (idOf(notice) != kept("notice")) keep("step", idOf(label));
    keep("notice", idOf(notice));
    keep("steps", steps);
    keep("cleared", cleared);
}

void centerNext(ImVec2 size) {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({(display.x - size.x) * 0.5f, (display.y - size.y) * 0.4f});
}

}  // namespace

void EditorWindow::toolButton(std::string_view id, bool on, ImU32 color) {
    const Action& action = *findAction(id);
    const bool enabled = action.enabled(workspace_);
    const float side = ui_.px(kButtonSide);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const bool pressed = ImGui::InvisibleButton(std::string{id}.c_str(), {side, side});
    widgets_.mark(format("Toolbar/{}", action.label), on ? "on" : "off");
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 to{at.x + side, at.y + side};
    if (on) list.AddRectFilled(at, to, palette::kAccentSoft, ui_.px(4.0f));
    if (enabled && ImGui::IsItemHovered()) list.AddRectFilled(at, to, palette::kHover, ui_.px(4.0f));
    const Icon icon = id == "run.play" && workspace_.play.running() ? Icon::Stop : iconOfAction(id);
    drawIcon(list, icon, {at.x + side * 0.5f, at.y + side * 0.5f}, ui_.px(15.0f),
             enabled ? color : palette::kIconOff);
    const std::string_view label = id == "run.play" && workspace_.play.running() ? "Stop" : action.label;
    tooltip(workspace_.settings.keys.labelOf(action, label));
    if (pressed) runAction(workspace_, id);
    ImGui::SameLine(0.0f, ui_.px(3.0f));
}

void EditorWindow::drawToolbar(float height) {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    beginBar("toolbar", {0.0f, ImGui::GetFrameHeight()}, {display.x, height}, {ui_.px(8.0f), ui_.px(5.0f)},
             chromeOf(workspace_.play));
    const auto gap = [&] { ImGui::SameLine(0.0f, ui_.px(14.0f)); };

    toolButton("file.save", false, workspace_.unsaved() ? palette::kWarning : palette::kText);
    toolButton("edit.undo", false, palette::kText);
    toolButton("edit.redo", false, palette::kText);
    gap();
    for (std::size_t i = 0; i < toolTable().size(); ++i) {
        if (i > 0 && toolTable()[i].forTiles != toolTable()[i - 1].forTiles) gap();
        const bool on = i == workspace_.toolIndex() && workspace_.canEdit();
        toolButton(toolTable()[i].action, on, on ? palette::kAccent : palette::kText);
    }
    gap();
    toolButton("view.snap", workspace_.grid.snap, workspace_.grid.snap ? palette::kAccent : palette::kText);
    snapMenu(ui_);

    const float side = ui_.px(31.0f);
    // In the middle, or behind the tools where those need the room.
    const float end = ImGui::GetItemRectMax().x + ui_.px(14.0f);
    ImGui::SameLine(std::max(std::floor(display.x * 0.5f - side * 1.5f), end));
    const bool running = workspace_.play.running();
    toolButton("run.play", false, running ? palette::kError : palette::kPlay);
    toolButton("run.pause", workspace_.play.paused(), palette::kText);
    toolButton("run.step", false, palette::kText);

    float width = 0.0f;
    for (const OverlayRow& row : overlayTable()) {
        if (row.ofEntities) continue;
        width += ImGui::CalcTextSize(std::string{row.label}.c_str()).x + ui_.px(21.0f);
    }
    width += ImGui::CalcTextSize("Physics").x + ui_.px(21.0f + 22.0f);
    ImGui::SameLine(display.x - width - ui_.px(6.0f));
    for (const OverlayRow& row : overlayTable()) {
        if (row.ofEntities) continue;  // in the list of layers
        const bool on = workspace_.shows(row.name);
        ImGui::PushStyleColor(ImGuiCol_Button, on ? palette::kAccentSoft : palette::kNothing);
        ImGui::PushStyleColor(ImGuiCol_Text, on ? palette::kText : palette::kTextDim);
        if (ImGui::Button(std::string{row.label}.c_str(), {0.0f, ui_.px(kButtonSide)}))
            workspace_.toggleOverlay(row.name);
        ImGui::PopStyleColor(2);
        widgets_.mark(format("Overlay/{}", row.name), on ? "on" : "off");
        tooltip(format("{} the overlay \"{}\" over the scene", on ? "Hide" : "Show", row.label));
        ImGui::SameLine(0.0f, ui_.px(4.0f));
    }
    drawPhysicsButton();
    ImGui::End();
}

void EditorWindow::drawPhysicsButton() {
    PhysicsView& view = workspace_.physics;
    ImGui::PushStyleColor(ImGuiCol_Button, view.on ? palette::kAccentSoft : palette::kNothing);
    ImGui::PushStyleColor(ImGuiCol_Text, view.on ? palette::kText : palette::kTextDim);
    if (ImGui::Button("Physics", {0.0f, ui_.px(kButtonSide)})) runAction(workspace_, "view.physics");
    widgets_.mark("Overlay/physics", view.on ? "on" : "off");
    tooltip(format("{} the physics over the scene, edited or playing  ({})", view.on ? "Hide" : "Show",
                   keysFor(workspace_, "view.physics")));
    ImGui::SameLine(0.0f, ui_.px(1.0f));
    ImGui::PopStyleColor(2);
    if (listArrow(ui_, "Overlay/physics layers", ui_.px(kButtonSide)))
        ImGui::OpenPopup("physics layers list");
    tooltip("What of the physics is shown");
    // At the edge of the window its size is known too late to fit in by itself.
    ImGui::SetNextWindowPos(
        {ImGui::GetIO().DisplaySize.x - ui_.px(4.0f), ImGui::GetItemRectMax().y + ui_.px(6.0f)},
        ImGuiCond_Always, {1.0f, 0.0f});
    if (!ImGui::BeginPopup("physics layers list")) return;
    physicsLayerItems("Overlay/physics/");
    ImGui::EndPopup();
}

void EditorWindow::physicsLayerItems(const std::string& path) {
    struct Choice {
        PhysicsReach reach;
        const char* label;
        const char* name;
        const char* hidden;
    };
    static constexpr Choice kChoices[] = {{PhysicsReach::Off, "Off", "off", "##off"},
                                          {PhysicsReach::Selected, "Selected", "selected", "##selected"},
                                          {PhysicsReach::All, "All", "all", "##all"}};
    PhysicsView& view = workspace_.physics;
    if (!ImGui::BeginTable("layers", 4, ImGuiTableFlags_SizingFixedFit)) return;
    ImGui::TableSetupColumn("");
    for (const Choice& choice : kChoices) ImGui::TableSetupColumn(choice.label);
    ImGui::TableHeadersRow();
    for (const OverlayRow& row : overlayTable()) {
        if (!row.ofEntities) continue;
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::AlignTextToFramePadding();
        ImGui::TextUnformatted(row.label.data(), row.label.data() + row.label.size());
        ImGui::PushID(row.name.data());
        for (const Choice& choice : kChoices) {
            ImGui::TableNextColumn();
            const bool chosen = workspace_.reachOf(row.name) == choice.reach;
            if (ImGui::RadioButton(choice.hidden, chosen)) workspace_.setReach(row.name, choice.reach);
            widgets_.mark(format("{}{}/{}", path, row.name, choice.name), chosen ? "on" : "off");
        }
        ImGui::PopID();
    }
    for (const PhysicsLayer& layer : physicsLayers()) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::AlignTextToFramePadding();
        ImGui::TextUnformatted(layer.label.data(), layer.label.data() + layer.label.size());
        tooltip(layer.doc);
        ImGui::PushID(layer.name.data());
        for (const Choice& choice : kChoices) {
            ImGui::TableNextColumn();
            if (choice.reach == PhysicsReach::Selected && !layer.ofBodies) continue;
            const bool chosen = view.reachOf(layer) == choice.reach;
            if (ImGui::RadioButton(choice.hidden, chosen)) view.setReach(layer, choice.reach);
            widgets_.mark(format("{}{}/{}", path, layer.name, choice.name), chosen ? "on" : "off");
            tooltip(layer.doc);
        }
        ImGui::PopID();
    }
    ImGui::EndTable();
}

void EditorWindow::drawStatus(float height) {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    beginBar("status", {0.0f, display.y - height}, {display.x, height}, {ui_.px(10.0f), ui_.px(4.0f)},
             chromeOf(workspace_.play));
    tellStep(workspace_);
    const Document& document = workspace_.document;
    std::string left = workspace_.notice.empty()
                           ? withKeys(workspace_, toolTable()[workspace_.toolIndex()].hint)
                           : workspace_.notice;
    if (workspace_.play.running()) {
        left =
            format("{} - tick {}", workspace_.play.paused() ? "Paused" : "Playing", workspace_.play.ticks());
    }
    ImGui::TextDisabled("%s", left.c_str());
    widgets_.mark("Status/notice", left);
    drawLogCounts(ui_);

    const std::string place = !ui_.mouseOverScene ? std::string{}
                                                  : format("{}, {}    ", std::lround(ui_.mouseInScene.x),
                                                           std::lround(ui_.mouseInScene.y));
    const std::string right =
        document.scenePath.empty()
            ? std::string{"No scene"}
            : format("{}{} of {} selected    {}%    {}", place, document.selection.size(),
                     document.objectCount(), std::lround(workspace_.view.zoom() * 100.0f),
                     workspace_.unsaved() ? "Not saved" : "Saved");
    ImGui::SameLine(display.x - ImGui::CalcTextSize(right.c_str()).x - ui_.px(10.0f));
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
        case WindowRequest::ChooseScene:
            ImGui::OpenPopup("Open scene");
            workspace_.request = WindowRequest::None;
            break;
        case WindowRequest::NameNewScene:
            ImGui::OpenPopup("New scene");
            newScene_.fill('\0');
            newSceneError_.clear();
            workspace_.request = WindowRequest::None;
            break;
        case WindowRequest::ChoosePrefab:
            ImGui::OpenPopup("Add prefab");
            workspace_.request = WindowRequest::None;
            break;
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
            // Applied before the next frame.
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
        case WindowRequest::Import:
        case WindowRequest::FindFile:
        case WindowRequest::FindCommand:
        case WindowRequest::NamePrefab:
        case WindowRequest::ShowOverrides:
        case WindowRequest::RenameSelected: break;
    }
    if (const auto visit = takePrefabVisit(workspace_)) leaveFor([this, visit] { go(workspace_, *visit); });
    drawSceneChooser();
    drawPrefabChooser();
    drawNewScene();
    if (std::exchange(askUnsaved_, false)) ImGui::OpenPopup("Unsaved changes");
    drawUnsaved();
    keep_.draw(ui_);
    prefabDialogs_.draw(ui_);
    safety_.draw(ui_);
    import_.draw(ui_);
    if (const std::string scene = finder_.draw(ui_); !scene.empty())
        leaveFor([=, this] { openScene(scene); });
    layoutMenu_.drawQuestion(ui_);
    preferences_.draw(ui_);
}

void EditorWindow::drawSceneChooser() {
    const ImVec2 size{ui_.px(420.0f), ui_.px(360.0f)};
    centerNext(size);
    ImGui::SetNextWindowSize(size);
    if (!ImGui::BeginPopupModal("Open scene", nullptr, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove))
        return;
    const std::vector<std::string> scenes = workspace_.scenes();
    if (scenes.empty()) {
        ImGui::TextWrapped(
            "This project has no scenes yet. Scenes are files in its folder scenes/ that end in "
            ".scene.json.");
    }
    beginChild("list", {0.0f, -ui_.px(38.0f)}, false);
    for (const std::string& path : scenes) {
        const bool chosen = ImGui::Selectable(path.c_str(), path == workspace_.document.scenePath);
        widgets_.mark("Open/" + path);
        if (!chosen) continue;
        ImGui::CloseCurrentPopup();
        leaveFor([this, path] { openScene(path); });
    }
    ImGui::EndChild();
    if (ImGui::Button("Cancel", {ui_.px(90.0f), 0.0f})) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

void EditorWindow::leaveFor(std::function<void()> next) {
    if (!workspace_.unsaved()) return next();
    next_ = std::move(next);
    askUnsaved_ = true;
}

void EditorWindow::drawNewScene() {
    const ImVec2 size{ui_.px(400.0f), ui_.px(150.0f)};
    centerNext(size);
    ImGui::SetNextWindowSize(size);
    if (!ImGui::BeginPopupModal("New scene", nullptr, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove))
        return;
    ImGui::TextDisabled("Its name in the folder scenes/");
    if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(-1.0f);
    bool done = ImGui::InputTextWithHint("##name", "for example cave", newScene_.data(), newScene_.size(),
                                         ImGuiInputTextFlags_EnterReturnsTrue);
    widgets_.mark("New/name", newScene_.data());
    ImGui::PushStyleColor(ImGuiCol_Text, palette::kWarning);
    ImGui::TextUnformatted(newSceneError_.c_str());
    ImGui::PopStyleColor();
    ImGui::SetCursorPosY(size.y - ui_.px(40.0f));
    const ImVec2 button{ui_.px(110.0f), 0.0f};
    done |= ImGui::Button("Create", button);
    widgets_.mark("New/Create");
    ImGui::SameLine();
    if (ImGui::Button("Cancel", button)) ImGui::CloseCurrentPopup();
    if (done) {
        const std::string name = newScene_.data();
        leaveFor([this, name] {
            const Result<Done> made = workspace_.createScene(name);
            newSceneError_ = made ? std::string{} : made.error().what;
            if (!made) workspace_.notice = made.error().text();
            ui_.viewReady = false;
        });
        if (newSceneError_.empty()) ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
}

void EditorWindow::drawPrefabChooser() {
    const ImVec2 size{ui_.px(420.0f), ui_.px(360.0f)};
    centerNext(size);
    ImGui::SetNextWindowSize(size);
    if (!ImGui::BeginPopupModal("Add prefab", nullptr, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove))
        return;
    const std::vector<std::string> files = workspace_.prefabFiles();
    if (files.empty()) {
        ImGui::TextWrapped("This project has no prefabs yet. Prefabs are files that end in .prefab.json.");
    } else {
        ImGui::TextDisabled("It is put into the middle of the picture.");
    }
    beginChild("list", {0.0f, -ui_.px(38.0f)}, false);
    for (const std::string& path : files) {
        const bool chosen = ImGui::Selectable(path.c_str());
        widgets_.mark("Prefab/" + path);
        if (!chosen) continue;
        ImGui::CloseCurrentPopup();
        const Vec2 at = snapped(workspace_.view.view().center, workspace_.grid.size);
        const Result<Done> added = addInstance(workspace_.prefabs(), path, at);
        workspace_.notice = added ? format("Added {}", path) : added.error().text();
    }
    ImGui::EndChild();
    if (ImGui::Button("Cancel", {ui_.px(90.0f), 0.0f})) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

void EditorWindow::drawUnsaved() {
    const ImVec2 size{ui_.px(400.0f), ui_.px(140.0f)};
    centerNext(size);
    ImGui::SetNextWindowSize(size);
    if (!ImGui::BeginPopupModal("Unsaved changes", nullptr,
                                ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove))
        return;
    ImGui::TextWrapped("%s has changes that are not saved.", workspace_.document.scenePath.c_str());
    ImGui::SetCursorPosY(size.y - ui_.px(40.0f));
    const auto leave = [&] {
        ImGui::CloseCurrentPopup();
        next_();
    };
    const ImVec2 button{ui_.px(110.0f), 0.0f};
    if (ImGui::Button("Save", button)) {
        if (workspace_.save()) {
            leave();
        } else if (workspace_.safety.onDisk() == FileWatch::State::Changed) {
            ImGui::CloseCurrentPopup();  // which one to keep is asked first
        }
    }
    widgets_.mark("Unsaved/Save");
    ImGui::SameLine();
    if (ImGui::Button("Discard", button)) leave();
    widgets_.mark("Unsaved/Discard");
    ImGui::SameLine();
    if (ImGui::Button("Cancel", button)) ImGui::CloseCurrentPopup();
    widgets_.mark("Unsaved/Cancel");
    ImGui::EndPopup();
}

}  // namespace plumb::editor::ui
