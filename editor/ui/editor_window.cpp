#include "editor/ui/editor_window.hpp"

#include <algorithm>
#include <array>

#include "editor/model/actions.hpp"
#include "editor/ui/overlays/overlay_list.hpp"
#include "editor/ui/ui_compat.hpp"
#include "scene/draw_scene.hpp"

namespace plumb::editor::ui {
namespace {

constexpr float kToolbarHeight = 38.0f;  // px at scale 1
constexpr float kStatusHeight = 24.0f;
constexpr std::size_t kTilesTab = 0;  // among those at the bottom
constexpr std::string_view kTallTabs[] = {"Tiles", "Tileset", "Assets", "Animation", "Profiler", "Input"};

/// The titles of the panels at the bottom, as their tabs stand.
std::vector<std::string_view> bottomTitles() {
    std::vector<std::string_view> titles;
    for (const PanelRow& row : panelTable()) {
        if (row.dock == Dock::Bottom) titles.emplace_back(row.title);
    }
    return titles;
}
constexpr std::array kNudgeKeys{Key::Left, Key::Right, Key::Up, Key::Down};

/// While a game plays, plain letters belong to it; what is left are function keys and Ctrl combinations.
bool actsWhilePlaying(const Event& event) {
    return event.modifiers.control || (event.key >= Key::F1 && event.key <= Key::F12);
}

}  // namespace

void tooltip(std::string_view text) {
    if (text.empty() || !ImGui::IsItemHovered() || ImGui::GetCurrentContext() == nullptr) return;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * 24.0f);
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

void actionItem(Ui& ui, std::string_view id, const std::string& path) {
    const Action& action = *findAction(id);
    const bool on = isOn(action, ui.workspace);
    const bool chosen = ImGui::MenuItem(std::string{action.label}.c_str(), action.shortcut.text().c_str(), on,
                                        action.enabled(ui.workspace));
    ui.widgets.mark(format("{}/{}", path, action.label));
    if (chosen) runAction(ui.workspace, id);
}

void selectionMenu(Ui& ui, const std::string& path) {
    for (const char* id : {"view.frame", "entity.rename", "edit.duplicate", "edit.delete"}) {
        actionItem(ui, id, path);
    }
    ImGui::Separator();
    for (const char* id : {"entity.group", "entity.hide", "entity.lock"}) {
        actionItem(ui, id, path);
    }
    ImGui::Separator();
    for (const char* id : {"entity.makePrefab", "entity.overrides", "entity.revert", "entity.apply"}) {
        actionItem(ui, id, path);
    }
    ImGui::Separator();
    for (const char* id : {"entity.create", "entity.prefab", "edit.paste"}) {
        actionItem(ui, id, path);
    }
}

EditorWindow::EditorWindow(Workspace& workspace, LogBook& log, ScenePicture* picture, Path fonts, float scale)
    : workspace_{workspace}, context_{ImGui::CreateContext()}, fontFolder_{std::move(fonts)}, ui_{workspace,
                                                                                                  widgets_,
                                                                                                  log,
                                                                                                  {},
                                                                                                  scale,
                                                                                                  picture} {
    ImGui::SetCurrentContext(context_);
    feed_ = std::make_unique<PlatformFeed>();
    setScale(scale);
    for (const PanelRow& row : panelTable()) {
        panels_.push_back(row.make());
    }
    workspace_.gameInput = [this] { return takeGameInput(); };
    log.tick = [this] { return workspace_.play.running() ? workspace_.play.ticks() : std::int64_t{-1}; };
}

EditorWindow::~EditorWindow() {
    workspace_.gameInput = nullptr;
    ui_.log.tick = nullptr;
    ImGui::DestroyContext(context_);
}

void EditorWindow::setScale(float scale) {
    ui_.scale = std::clamp(scale, 0.75f, 3.0f);
    ui_.fonts = applyTheme(fontFolder_, ui_.scale);
    buildFonts();
    fontsChanged_ = true;
}

void EditorWindow::frame(const FrameInput& input) {
    ImGui::SetCurrentContext(context_);
    if (workspace_.request == WindowRequest::LargerText || workspace_.request == WindowRequest::SmallerText) {
        setScale(ui_.scale + (workspace_.request == WindowRequest::LargerText ? 0.125f : -0.125f));
        workspace_.request = WindowRequest::None;
        return;  // the fonts must be on the graphics card before the next frame
    }
    const std::span<const Event> events = feed_->beginFrame(input);
    ImGui::NewFrame();
    widgets_.beginFrame();
    handleKeys(events);
    playGame(input.seconds);
    hotReload_.poll(ImGui::GetTime());
    showAssetPanel();
    workspace_.tend(input.seconds);
    drawMenus();

    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float top = ImGui::GetFrameHeight();
    const float toolbar = ui_.px(kToolbarHeight);
    const float status = ui_.px(kStatusHeight);
    drawToolbar(toolbar);
    drawPanes({0.0f, top + toolbar}, {display.x, std::max(display.y - top - toolbar - status, 1.0f)});
    drawStatus(status);
    drawDialogs();
    ImGui::Render();
}

void EditorWindow::handleKeys(std::span<const Event> events) {
    const bool typing = ImGui::GetIO().WantTextInput;
    const bool playing = workspace_.play.running() && !workspace_.play.paused();
    ui_.panHeld = !typing && !playing && feed_->held(Key::Space);
    for (const Event& event : events) {
        if (ui_.takeEvent && ui_.takeEvent(event)) continue;
        if (event.kind == EventKind::Quit) workspace_.request = WindowRequest::Quit;
        if (event.kind == EventKind::FileDropped) bringIn(workspace_, event.text);
        if (playing && !typing && isForGame(event)) devices_.handle(event);
        if (event.kind != EventKind::KeyDown || typing) continue;
        if (event.key == Key::Escape && ui_.takesEscape) continue;
        if (anyPopupOpen()) {  // keys belong to the menu, and Esc leaves it
            if (event.key == Key::Escape) closePopups();
            continue;
        }
        if (!workspace_.play.running() || actsWhilePlaying(event)) runShortcut(workspace_, event);
    }
    ui_.takesEscape = false;
    // A widget that vanished in the middle of a drag never says that it ended.
    const bool nudging =
        std::any_of(kNudgeKeys.begin(), kNudgeKeys.end(), [&](Key key) { return feed_->held(key); });
    if (workspace_.undo.inGesture() && !ImGui::IsAnyItemActive() && !feed_->held(MouseButton::Left) &&
        !nudging) {
        workspace_.undo.endGesture();
    }
}

/// What is pressed or turned beside the scene belongs to the editor.
bool EditorWindow::isForGame(const Event& event) const {
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
    if (!workspace_.play.paused()) ui_.playAlpha = workspace_.play.advance(seconds, takeGameInput());
}

void EditorWindow::drawMenus() {
    if (!ImGui::BeginMainMenuBar()) return;
    for (const char* menu : {"File", "Edit", "Entity", "Arrange", "Tool", "Tiles", "View", "Run"}) {
        const bool open = ImGui::BeginMenu(menu);
        widgets_.mark(std::string{"Menu/"} + menu);
        if (!open) continue;
        for (const Action& action : actionTable()) {
            if (action.menu != menu) continue;
            if (action.id.empty()) {
                ImGui::Separator();
                continue;
            }
            actionItem(ui_, action.id, std::string{"Menu/"} + menu);
        }
        if (std::string_view{menu} == "View") drawOverlayMenu();
        ImGui::EndMenu();
    }
    const std::string title =
        format("{}{}{}", workspace_.project.name, workspace_.document.scenePath.empty() ? "" : "  /  ",
               workspace_.document.scenePath);
    const float width = ImGui::CalcTextSize(title.c_str()).x;
    ImGui::SetCursorPosX(std::max(ImGui::GetIO().DisplaySize.x - width - ui_.px(28.0f), ui_.px(360.0f)));
    ImGui::TextDisabled("%s", title.c_str());
    if (workspace_.unsaved()) {
        const ImVec2 from = ImGui::GetItemRectMax();
        ImGui::GetWindowDrawList()->AddCircleFilled(
            {from.x + ui_.px(9.0f), from.y - ImGui::GetTextLineHeight() * 0.5f}, ui_.px(3.5f),
            palette::kWarning);
    }
    ImGui::EndMainMenuBar();
}

void EditorWindow::drawOverlayMenu() {
    ImGui::Separator();
    for (const OverlayRow& row : overlayTable()) {
        if (findAction(format("view.{}", row.name)) != nullptr) continue;  // it is in the menu by that
        const std::string label{row.label};
        if (ImGui::MenuItem(label.c_str(), nullptr, workspace_.shows(row.name)))
            workspace_.toggleOverlay(row.name);
        widgets_.mark("Menu/View/" + label);
    }
    const bool open = ImGui::BeginMenu("Physics layers");
    widgets_.mark("Menu/View/Physics layers");
    if (!open) return;
    physicsLayerItems("Menu/View/Physics layers/");
    ImGui::EndMenu();
}

void EditorWindow::showAssetPanel() {
    std::string wanted = std::exchange(workspace_.panelToShow, {});
    if (!workspace_.assetToShow.empty()) wanted = "Assets";
    if (!workspace_.assetToEdit.empty()) wanted = "Animation";
    if (wanted.empty()) return;
    const std::vector<std::string_view> titles = bottomTitles();
    const auto at = std::find(titles.begin(), titles.end(), wanted);
    if (at != titles.end()) bottomTab_ = static_cast<std::size_t>(at - titles.begin());
}

void EditorWindow::showTilesWhilePainting() {
    const bool painting = workspace_.paintsTiles();
    if (std::exchange(paintedTiles_, painting) == painting) return;
    if (painting) {
        tabBefore_ = bottomTab_;
        bottomTab_ = kTilesTab;
    } else if (bottomTab_ == kTilesTab) {
        bottomTab_ = tabBefore_;
    }
}

void EditorWindow::drawPanes(ImVec2 from, ImVec2 size) {
    ImGui::SetNextWindowPos(from);
    ImGui::SetNextWindowSize(size);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.0f, 0.0f});
    ImGui::PushStyleColor(ImGuiCol_WindowBg, palette::kLine);
    ImGui::Begin("panes", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBringToFrontOnFocus);
    ImGui::PopStyleColor();
    ImGui::PopStyleVar();

    showTilesWhilePainting();
    const std::vector<std::string_view> titles = bottomTitles();
    const std::string_view title = titles[std::min(bottomTab_, titles.size() - 1)];
    const bool tall = std::find(std::begin(kTallTabs), std::end(kTallTabs), title) != std::end(kTallTabs);
    float& bottomPart = tall ? layout_.tiles : layout_.bottom;
    const float gap = ui_.px(3.0f);
    const float left = std::floor(size.x * layout_.left);
    const float right = std::floor(size.x * layout_.right);
    const float bottom = std::floor(size.y * bottomPart);
    const float middle = size.x - left - right - 2.0f * gap;
    const float upper = size.y - bottom - gap;
    drawPane(Dock::Left, from, {left, size.y});
    drawPane(Dock::Center, {from.x + left + gap, from.y}, {middle, upper});
    drawPane(Dock::Bottom, {from.x + left + gap, from.y + upper + gap}, {middle, bottom});
    drawPane(Dock::Right, {from.x + size.x - right, from.y}, {right, size.y});
    splitter("Splitter/left", {from.x + left, from.y}, {gap, size.y}, true, layout_.left, size.x, 1.0f);
    splitter("Splitter/right", {from.x + size.x - right - gap, from.y}, {gap, size.y}, true, layout_.right,
             size.x, -1.0f);
    splitter("Splitter/bottom", {from.x + left + gap, from.y + upper}, {middle, gap}, false, bottomPart,
             size.y, -1.0f);
    ImGui::End();
}

void EditorWindow::splitter(const char* id, ImVec2 from, ImVec2 size, bool vertical, float& part, float whole,
                            float sign) {
    ImGui::SetCursorScreenPos(from);
    ImGui::InvisibleButton(id, {std::max(size.x, 1.0f), std::max(size.y, 1.0f)});
    widgets_.mark(id);
    const bool held = ImGui::IsItemActive();
    if (held || ImGui::IsItemHovered()) {
        ImGui::SetMouseCursor(vertical ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
        ImGui::GetWindowDrawList()->AddRectFilled(from, {from.x + size.x, from.y + size.y},
                                                  held ? palette::kAccent : palette::kAccentSoft);
    }
    const ImVec2 delta = ImGui::GetIO().MouseDelta;
    if (held) part = std::clamp(part + sign * (vertical ? delta.x : delta.y) / whole, 0.1f, 0.5f);
}

void EditorWindow::drawPane(Dock dock, ImVec2 from, ImVec2 size) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float header = ui_.px(27.0f);
    list.AddRectFilled(from, {from.x + size.x, from.y + size.y}, palette::kPanel);
    list.AddRectFilled(from, {from.x + size.x, from.y + header}, palette::kHeader);

    std::vector<std::size_t> here;
    for (std::size_t i = 0; i < panels_.size(); ++i) {
        if (panelTable()[i].dock == dock) here.push_back(i);
    }
    std::size_t shown = dock == Dock::Bottom ? std::min(bottomTab_, here.size() - 1) : 0;
    float x = from.x;
    for (std::size_t i = 0; i < here.size(); ++i) {
        const char* title = panelTable()[here[i]].title;
        const float width = ImGui::CalcTextSize(title).x + ui_.px(22.0f);
        if (here.size() > 1) {
            ImGui::SetCursorScreenPos({x, from.y});
            if (ImGui::InvisibleButton(title, {width, header})) bottomTab_ = shown = i;
            widgets_.mark(std::string{"Tab/"} + title);
            if (i == shown) list.AddRectFilled({x, from.y}, {x + width, from.y + header}, palette::kPanel);
            if (i == shown)
                list.AddRectFilled({x, from.y}, {x + width, from.y + ui_.px(2.0f)}, palette::kAccent);
        }
        const float top = from.y + (header - ImGui::GetTextLineHeight()) * 0.5f;
        list.AddText({x + ui_.px(11.0f), top}, i == shown ? palette::kText : palette::kTextDim, title);
        x += width;
    }

    const bool scene = dock == Dock::Center;
    ImGui::SetCursorScreenPos({from.x, from.y + header});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding,
                        scene ? ImVec2{0.0f, 0.0f} : ImVec2{ui_.px(8.0f), ui_.px(8.0f)});
    ImGuiWindowFlags flags = scene ? ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse : 0;
    flags |= ImGuiWindowFlags_AlwaysUseWindowPadding;
    beginChild(panelTable()[here[shown]].title, {size.x, std::max(size.y - header, 1.0f)}, false, flags);
    ImGui::PopStyleVar();
    panels_[here[shown]]->draw(ui_);
    ImGui::EndChild();
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
