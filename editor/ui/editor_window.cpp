#include "editor/ui/editor_window.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "editor/model/actions.hpp"
#include "editor/model/play/scene_of_game.hpp"
#include "editor/model/project/project_habits.hpp"
#include "editor/ui/overlays/overlay_list.hpp"
#include "editor/ui/prefab_strip.hpp"
#include "editor/ui/toolbar.hpp"
#include "editor/ui/ui_compat.hpp"
#include "editor/ui/widgets/fitted_text.hpp"
#include "editor/ui/widgets/physics_layers.hpp"
#include "scene/drawing/draw_scene.hpp"

namespace plumb::editor::ui {
namespace {

constexpr float kToolbarHeight = 38.0f;  // px at scale 1: height of the toolbar
constexpr float kStatusHeight = 24.0f;
constexpr float kRunPause = 1.0f;  // s: after a longer pause, moving by arrow keys starts a new undo step

/// Time of the last key press merged into the open undo step (s of ImGui's clock); negative if that step was
/// not started by keys. Successive moves by arrow keys are one undo step, until a pause or a mouse press.
float& keysAddedAt() {
    return *ImGui::GetStateStorage()->GetFloatRef(ImGui::GetID("gesture of keys"), -1.0f);
}

void endGestureOfKeys(UndoStack& undo) {
    if (std::exchange(keysAddedAt(), -1.0f) >= 0.0f) undo.endGesture();
}

/// True for keys that the editor handles while a game runs: function keys and Ctrl combinations. The game
/// gets all other keys.
bool actsWhilePlaying(const Event& event) {
    return event.modifiers.control || (event.key >= Key::F1 && event.key <= Key::F12);
}

}  // namespace

void tooltip(std::string_view text) {
    // Shown for disabled items too: their tooltips explain why they are disabled.
    if (text.empty() || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * 24.0f);
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

void actionItem(Ui& ui, std::string_view id, const std::string& path) {
    const Action& action = *findAction(id);
    const bool on = isOn(action, ui.workspace);
    const bool chosen = ImGui::MenuItem(std::string{action.label}.c_str(),
                                        ui.workspace.settings.keys.shownOf(action).text().c_str(), on,
                                        action.enabled(ui.workspace));
    ui.widgets.mark(format("{}/{}", path, action.label));
    if (chosen) runAction(ui.workspace, id);
}

void selectionMenu(Ui& ui, const std::string& path) {
    const auto items = [&](std::initializer_list<const char*> actions) {
        for (const char* id : actions) actionItem(ui, id, path);
    };
    const Workspace& workspace = ui.workspace;
    items({"edit.cut", "edit.copy", "edit.paste", "edit.duplicate", "edit.delete"});
    ImGui::Separator();
    items({"view.frame", "entity.rename", "entity.group", "entity.hide", "entity.lock"});
    ImGui::Separator();
    items({"entity.makePrefab"});
    // These prefab actions apply only to prefab instances.
    if (workspace.selectsInstance())
        items({"entity.editPrefab", "entity.overrides", "entity.revert", "entity.apply"});
    ImGui::Separator();
    items({"entity.create", "entity.camera", "entity.particles", "entity.prefab"});
}

EditorWindow::EditorWindow(Workspace& workspace, LogBook& log, SceneTexture* picture, Path fonts, float scale)
    : workspace_{workspace}, context_{ImGui::CreateContext()}, fontFolder_{std::move(fonts)}, ui_{workspace,
                                                                                                  widgets_,
                                                                                                  log,
                                                                                                  {},
                                                                                                  scale,
                                                                                                  picture} {
    ImGui::SetCurrentContext(context_);
    // The renderer supports vertex offsets: a draw list may have more vertices than a 16-bit index can
    // address, e.g. for the collision shapes of all tiles.
    ImGui::GetIO().BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    feed_ = std::make_unique<PlatformFeed>();
    workspace_.settings.scale = scale;
    applyLook();
    workspace_.tiles.rightErases = workspace_.settings.rightErases;
    workspace_.gameInput = [this] { return takeGameInput(); };
    log.tick = [this] { return workspace_.play.running() ? workspace_.play.ticks() : std::int64_t{-1}; };
    log.game = [this] { return workspace_.play.games(); };
    if (workspace_.project.isNone) welcome_.open(ui_);
}

EditorWindow::~EditorWindow() {
    keepGrid(workspace_);
    workspace_.gameInput = nullptr;
    ui_.log.tick = nullptr;
    ui_.log.game = nullptr;
    ImGui::DestroyContext(context_);
}

bool EditorWindow::looksOld() const {
    const Settings& settings = workspace_.settings;
    return settings.scale != ui_.scale || settings.theme != theme_ || settings.textSize != textSize_;
}

void EditorWindow::applyLook() {
    Settings& settings = workspace_.settings;
    settings.scale = std::clamp(settings.scale, Settings::kLeastScale, Settings::kMostScale);
    ui_.scale = settings.scale;
    theme_ = settings.theme;
    textSize_ = settings.textSize;
    ui_.fonts = applyTheme(fontFolder_, theme_, ui_.scale, textSize_);
    buildFonts();
    fontsChanged_ = true;
}

void EditorWindow::frame(const FrameInput& input) {
    ImGui::SetCurrentContext(context_);
    if (looksOld()) {
        applyLook();
        feed_->keep(input.events);
        return;  // the fonts must be on the graphics card before the next frame
    }
    workspace_.settings.rightErases = workspace_.tiles.rightErases;
    const std::span<const Event> events = feed_->beginFrame(input);
    newFrame(dialogOpen() && !preferences_.listening());
    widgets_.beginFrame();
    if (welcome_.shown()) {
        handleWelcomeKeys(events);
        welcome_.draw(ui_, ImGui::GetIO().DisplaySize);
    } else {
        handleKeys(events);
        playGame(input.seconds);
        hotReload_.poll(ImGui::GetTime());
        if (workspace_.followCode) workspace_.followCode(ImGui::GetTime());
        showAssetPanel();
        workspace_.update(input.seconds);
        drawAll();
    }
    drawDialogs();
    ImGui::Render();
}

void EditorWindow::drawAll() {
    drawMenus();
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float top = ImGui::GetFrameHeight();
    const float toolbar = ui_.px(kToolbarHeight);
    const float status = ui_.px(kStatusHeight);
    drawToolbar(ui_, top, toolbar);
    const float strip = drawPrefabStrip(ui_, top + toolbar, display.x);
    const float above = top + toolbar + strip;
    panes_.draw(ui_, {0.0f, above}, {display.x, std::max(display.y - above - status, 1.0f)});
    drawStatus(status);
}

void EditorWindow::handleWelcomeKeys(std::span<const Event> events) {
    for (const Event& event : events) {
        if (event.kind == EventKind::Quit) workspace_.request = WindowRequest::Quit;
        if (event.kind != EventKind::KeyDown || event.key != Key::Escape) continue;
        if (anyPopupOpen()) {
            closePopups();
        } else if (!ImGui::GetIO().WantTextInput) {
            welcome_.close(ui_);
        }
    }
}

void EditorWindow::handleKeys(std::span<const Event> events) {
    const bool typing = ImGui::GetIO().WantTextInput;
    const bool running = workspace_.play.running();
    const bool playing = running && !workspace_.play.paused();
    ui_.panHeld = !typing && !playing && feed_->held(Key::Space);
    for (const Event& event : events) {
        if (event.kind == EventKind::MouseDown) endGestureOfKeys(workspace_.undo);
        if (ui_.takeEvent && ui_.takeEvent(event)) continue;
        if (event.kind == EventKind::Quit) workspace_.request = WindowRequest::Quit;
        if (event.kind == EventKind::FileDropped) addDroppedFile(workspace_, event.text);
        if (running && isForGame(event, typing)) devices_.handle(event);
        if (preferences_.take(workspace_.settings.keys, event)) continue;
        if (event.kind != EventKind::KeyDown) continue;
        if (event.key == Key::Escape && dialogOpen() && !ui_.takesEscape) {
            closePopups();  // from a text field, too
            continue;
        }
        if (typing || (event.key == Key::Escape && ui_.takesEscape)) continue;
        if (anyPopupOpen()) {  // the popup gets all keys; Esc closes it
            if (event.key == Key::Escape) closePopups();
            continue;
        }
        if (workspace_.play.running() && !actsWhilePlaying(event)) continue;
        const bool dragging = feed_->held(MouseButton::Left);
        if (runShortcut(workspace_, event) && !dragging && workspace_.undo.inGesture())
            keysAddedAt() = static_cast<float>(ImGui::GetTime());
    }
    ui_.takesEscape = false;
    // Ends the undo step of a widget that disappeared during a drag and so could not end it.
    const bool ofKeys = keysAddedAt() >= 0.0f;
    if (ofKeys && static_cast<float>(ImGui::GetTime()) - keysAddedAt() > kRunPause)
        endGestureOfKeys(workspace_.undo);
    if (!ofKeys && workspace_.undo.inGesture() && !ImGui::IsAnyItemActive() &&
        !feed_->held(MouseButton::Left))
        workspace_.undo.endGesture();
}

/// True if the game gets the event. Typed text, and mouse presses and wheel events outside the scene view, go
/// only to the editor; releases go to both. Also used while the game is paused, so that keys held on resuming
/// have an effect.
bool EditorWindow::isForGame(const Event& event, bool typing) const {
    if (typing && (event.kind == EventKind::KeyDown || event.kind == EventKind::TextInput)) return false;
    const bool begins = event.kind == EventKind::MouseDown || event.kind == EventKind::MouseWheel;
    return !begins || ui_.mouseOverScene;
}

InputFrame EditorWindow::takeGameInput() {
    InputFrame frame = devices_.take();
    if (!workspace_.play.running()) return frame;
    const View game = cameraView(workspace_.play.world(), workspace_.project.picture, 1.0f);
    frame.setMouse(toScreen(game, ui_.mouseInScene));
    return frame;
}

void EditorWindow::playGame(float seconds) {
    if (!workspace_.play.running()) {
        ui_.playAlpha = 1.0f;
        devices_.releaseAll();
        return;
    }
    // Discards keys that were pressed and released during the pause.
    if (workspace_.play.paused()) static_cast<void>(devices_.take());
    if (!workspace_.play.paused()) ui_.playAlpha = workspace_.play.advance(seconds, takeGameInput());
}

void EditorWindow::drawMenu(const char* menu) {
    const bool open = ImGui::BeginMenu(menu);
    widgets_.mark(std::string{"Menu/"} + menu);
    if (!open) return;
    for (const Action& action : actionTable()) {
        if (action.menu != menu) continue;
        if (action.id.empty()) {
            ImGui::Separator();
            continue;
        }
        actionItem(ui_, action.id, std::string{"Menu/"} + menu);
        // The menu Entity repeats these actions of the menu Edit, as users expect them in both.
        if (action.id == "entity.rename") {
            for (const char* id : {"edit.duplicate", "edit.delete"})
                actionItem(ui_, id, std::string{"Menu/"} + menu);
        }
    }
    if (std::string_view{menu} == "View") {
        layoutMenu_.drawItems(ui_);
        drawOverlayMenu();
    }
    ImGui::EndMenu();
}

void EditorWindow::drawMenus() {
    if (!ImGui::BeginMainMenuBar()) return;
    constexpr std::array kMenus{"File", "Edit", "Entity", "Arrange", "Tool", "Tiles", "View", "Run"};
    constexpr const char* kMore = "\xe2\x80\xa6";
    const auto width = [](const char* menu) {
        return ImGui::CalcTextSize(menu).x + 2.0f * ImGui::GetStyle().ItemSpacing.x;
    };
    const float end = ImGui::GetIO().DisplaySize.x;
    float left = ImGui::GetCursorPosX();
    for (const char* menu : kMenus) left += width(menu);
    const bool all = left <= end;
    // Menus for which there is no room become submenus of an extra last menu.
    std::size_t shown = 0;
    for (; shown < kMenus.size(); ++shown) {
        if (!all && ImGui::GetCursorPosX() + width(kMenus[shown]) + width(kMore) > end) break;
        drawMenu(kMenus[shown]);
    }
    if (!all) {
        const bool open = ImGui::BeginMenu(kMore);
        widgets_.mark("Menu/more");
        for (std::size_t i = shown; open && i < kMenus.size(); ++i) drawMenu(kMenus[i]);
        if (open) ImGui::EndMenu();
    }
    drawTitle();
    ImGui::EndMainMenuBar();
}

/// Draws the names of the project and the scene at the right end of the menu bar, as far as there is room.
void EditorWindow::drawTitle() {
    const std::string played = sceneOfGame(workspace_);
    const std::string& scene = played.empty() ? workspace_.document.scenePath : played;
    const std::string title = format("{}{}{}", workspace_.project.name, scene.empty() ? "" : "  /  ", scene);
    const float end = ImGui::GetIO().DisplaySize.x - ui_.px(28.0f);
    const float from = ImGui::GetCursorPosX() + ui_.px(14.0f);
    const std::string shown = fittedText(title, end - from);
    if (shown.empty()) return;
    ImGui::SetCursorPosX(std::max(end - ImGui::CalcTextSize(shown.c_str()).x, from));
    ImGui::TextDisabled("%s", shown.c_str());
    widgets_.mark("Menu/title", title);
    if (shown != title) tooltip(title);
    if (!workspace_.unsaved()) return;
    const ImVec2 corner = ImGui::GetItemRectMax();
    ImGui::GetWindowDrawList()->AddCircleFilled(
        {corner.x + ui_.px(9.0f), corner.y - ImGui::GetTextLineHeight() * 0.5f}, ui_.px(3.5f),
        palette::kWarning);
}

void EditorWindow::drawOverlayMenu() {
    ImGui::Separator();
    for (const OverlayRow& row : overlayTable()) {
        if (findAction(format("view.{}", row.name)) != nullptr) continue;  // has its own menu item
        const std::string label{row.label};
        if (ImGui::MenuItem(label.c_str(), nullptr, workspace_.shows(row.name)))
            workspace_.toggleOverlay(row.name);
        widgets_.mark("Menu/View/" + label);
    }
    const bool open = ImGui::BeginMenu("Physics layers");
    widgets_.mark("Menu/View/Physics layers");
    if (!open) return;
    physicsLayerItems(ui_, "Menu/View/Physics layers/");
    ImGui::EndMenu();
}

void EditorWindow::showAssetPanel() {
    // A request "PANEL/PART" is cleared by the panel or dialog that shows the part.
    std::string wanted = workspace_.panelToShow.substr(0, workspace_.panelToShow.find('/'));
    if (wanted.size() == workspace_.panelToShow.size()) workspace_.panelToShow.clear();
    if (!workspace_.assetToShow.empty()) wanted = "Assets";
    if (!workspace_.assetToEdit.empty()) wanted = "Animation";
    if (!wanted.empty()) workspace_.settings.layout.show(wanted);
}

MouseShape EditorWindow::mouseShape() const {
    switch (ImGui::GetMouseCursor()) {
        case ImGuiMouseCursor_TextInput: return MouseShape::Text;
        case ImGuiMouseCursor_ResizeAll: return MouseShape::Move;
        case ImGuiMouseCursor_ResizeEW: return MouseShape::SizeHorizontal;
        case ImGuiMouseCursor_ResizeNS: return MouseShape::SizeVertical;
        case ImGuiMouseCursor_ResizeNESW:
        case ImGuiMouseCursor_ResizeNWSE: return MouseShape::SizeDiagonal;
        case ImGuiMouseCursor_Hand: return MouseShape::Hand;
        case ImGuiMouseCursor_NotAllowed: return MouseShape::Forbidden;
        default: return MouseShape::Arrow;
    }
}

}  // namespace plumb::editor::ui
