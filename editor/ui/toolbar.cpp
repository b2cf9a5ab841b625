#include "editor/ui/toolbar.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/text.hpp"
#include "editor/model/actions.hpp"
#include "editor/model/input/key_words.hpp"
#include "editor/ui/icons.hpp"
#include "editor/ui/overlays/overlay_list.hpp"
#include "editor/ui/ui_compat.hpp"
#include "editor/ui/widgets/bar.hpp"
#include "editor/ui/widgets/list_arrow.hpp"
#include "editor/ui/widgets/physics_layers.hpp"
#include "editor/ui/widgets/snap_menu.hpp"

namespace plumb::editor::ui {
namespace {

constexpr float kButtonSide = 28.0f;  // px at scale 1: height of all items of the toolbar
constexpr float kBetween = 3.0f;      // px at scale 1: between two buttons of a group
constexpr float kGap = 14.0f;         // px at scale 1: between two groups
constexpr float kMargin = 8.0f;       // px at scale 1: left and right of the toolbar
constexpr float kTop = 5.0f;          // px at scale 1: above the buttons
constexpr float kWordMargin = 7.0f;   // px at scale 1: on both sides of a button's text
constexpr const char* kMoreList = "toolbar list";

enum class Side : unsigned char { Left, Middle, Right };

struct Group {
    Side side;
    int worth;  ///< priority: groups with a lower one are hidden first if the window is too narrow
    float (*width)(const Ui& ui);
    void (*draw)(Ui& ui);
    void (*list)(Ui& ui);                        ///< draws the group as items of a menu
    bool (*inHand)(const Workspace& workspace);  ///< true if the active tool is in this group; null: no tools
};

float buttonsWidth(const Ui& ui, std::size_t count) {
    const auto buttons = static_cast<float>(count);
    return ui.px(kButtonSide) * buttons + ui.px(kBetween) * (buttons - 1.0f);
}

void button(Ui& ui, std::string_view id, bool on, ImU32 color) {
    Workspace& workspace = ui.workspace;
    const Action& action = *findAction(id);
    const bool enabled = action.enabled(workspace);
    const float side = ui.px(kButtonSide);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const bool pressed = ImGui::InvisibleButton(std::string{id}.c_str(), {side, side});
    ui.widgets.mark(format("Toolbar/{}", action.label), on ? "on" : "off");
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 to{at.x + side, at.y + side};
    if (on) list.AddRectFilled(at, to, palette::kAccentSoft, ui.px(4.0f));
    if (enabled && ImGui::IsItemHovered()) list.AddRectFilled(at, to, palette::kHover, ui.px(4.0f));
    const bool stops = id == "run.play" && workspace.play.running();
    drawIcon(list, stops ? Icon::Stop : iconOfAction(id), {at.x + side * 0.5f, at.y + side * 0.5f},
             ui.px(15.0f), enabled ? color : palette::kIconOff);
    tooltip(workspace.settings.keys.labelOf(action, stops ? "Stop" : action.label));
    if (pressed) runAction(workspace, id);
    ImGui::SameLine(0.0f, ui.px(kBetween));
}

void entry(Ui& ui, std::string_view id) { actionItem(ui, id, "Toolbar/more"); }

constexpr std::array kFile{"file.save", "edit.undo", "edit.redo"};
constexpr std::array kRun{"run.play", "run.pause", "run.step"};

void drawFile(Ui& ui) {
    button(ui, kFile[0], false, ui.workspace.unsaved() ? palette::kWarning : palette::kText);
    button(ui, kFile[1], false, palette::kText);
    button(ui, kFile[2], false, palette::kText);
}

void drawRun(Ui& ui) {
    const PlayMode& play = ui.workspace.play;
    button(ui, kRun[0], false, play.running() ? palette::kError : palette::kPlay);
    button(ui, kRun[1], play.paused(), palette::kText);
    button(ui, kRun[2], false, palette::kText);
}

template <const auto& Ids>
void list(Ui& ui) {
    for (const char* id : Ids) entry(ui, id);
}
template <const auto& Ids>
float width(const Ui& ui) {
    return buttonsWidth(ui, Ids.size());
}

template <bool ForTiles>
std::size_t countTools() {
    const std::vector<ToolRow>& rows = toolTable();
    return static_cast<std::size_t>(
        std::count_if(rows.begin(), rows.end(), [](const ToolRow& row) { return row.forTiles == ForTiles; }));
}
template <bool ForTiles>
float toolsWidth(const Ui& ui) {
    return buttonsWidth(ui, countTools<ForTiles>());
}
template <bool ForTiles>
void drawTools(Ui& ui) {
    const std::vector<ToolRow>& rows = toolTable();
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (rows[i].forTiles != ForTiles) continue;
        const bool on = i == ui.workspace.toolIndex() && ui.workspace.canEdit();
        button(ui, rows[i].action, on, on ? palette::kAccent : palette::kText);
    }
}
template <bool ForTiles>
void listTools(Ui& ui) {
    for (const ToolRow& row : toolTable()) {
        if (row.forTiles == ForTiles) entry(ui, row.action);
    }
}
template <bool ForTiles>
bool toolInHand(const Workspace& workspace) {
    return workspace.paintsTiles() == ForTiles;
}

float snapWidth(const Ui& ui) { return ui.px(kButtonSide + kBetween) + listArrowWidth(ui); }
void drawSnap(Ui& ui) {
    const bool on = ui.workspace.grid.snap;
    button(ui, "view.snap", on, on ? palette::kAccent : palette::kText);
    snapMenu(ui);
}
void listSnap(Ui& ui) {
    entry(ui, "view.snap");
    const bool open = ImGui::BeginMenu("Snap settings");
    ui.widgets.mark("Toolbar/more/Snap settings");
    if (!open) return;
    snapItems(ui);
    ImGui::EndMenu();
}

float wordWidth(const Ui& ui, std::string_view word) {
    return std::ceil(ImGui::CalcTextSize(word.data(), word.data() + word.size()).x) +
           2.0f * ui.px(kWordMargin);
}
/// Draws a text button that toggles an overlay. @param on  the overlay is shown
bool wordButton(Ui& ui, std::string_view word, bool on) {
    ImGui::PushStyleColor(ImGuiCol_Button, on ? palette::kAccentSoft : palette::kNothing);
    ImGui::PushStyleColor(ImGuiCol_Text, on ? palette::kText : palette::kTextDim);
    const bool pressed = ImGui::Button(std::string{word}.c_str(), {wordWidth(ui, word), ui.px(kButtonSide)});
    ImGui::PopStyleColor(2);
    return pressed;
}

float overlaysWidth(const Ui& ui) {
    float width = -ui.px(kBetween);
    for (const OverlayRow& row : overlayTable()) {
        if (!row.ofEntities) width += wordWidth(ui, row.label) + ui.px(kBetween);
    }
    return width;
}
void drawOverlays(Ui& ui) {
    for (const OverlayRow& row : overlayTable()) {
        if (row.ofEntities) continue;  // shown in the list of physics layers instead
        const bool on = ui.workspace.shows(row.name);
        if (wordButton(ui, row.label, on)) ui.workspace.toggleOverlay(row.name);
        ui.widgets.mark(format("Overlay/{}", row.name), on ? "on" : "off");
        tooltip(format("{} the overlay \"{}\" over the scene", on ? "Hide" : "Show", row.label));
        ImGui::SameLine(0.0f, ui.px(kBetween));
    }
}
void listOverlays(Ui& ui) {
    for (const OverlayRow& row : overlayTable()) {
        if (row.ofEntities) continue;
        const bool on = ui.workspace.shows(row.name);
        if (ImGui::MenuItem(std::string{row.label}.c_str(), nullptr, on))
            ui.workspace.toggleOverlay(row.name);
        ui.widgets.mark(format("Toolbar/more/{}", row.label), on ? "on" : "off");
    }
}

/// Begins a popup at the right edge of the window, below a button. ImGui cannot keep it inside the window in
/// its first frame, so it is aligned to the edge.
/// @param top  px: lower edge of the button
bool beginEdgeList(const Ui& ui, const char* name, float top) {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float from = top + ui.px(6.0f);
    ImGui::SetNextWindowPos({display.x - ui.px(4.0f), from}, ImGuiCond_Always, {1.0f, 0.0f});
    ImGui::SetNextWindowSizeConstraints(
        {0.0f, 0.0f}, {display.x - ui.px(8.0f), std::max(display.y - from - ui.px(4.0f), ui.px(40.0f))});
    return ImGui::BeginPopup(name);
}

float physicsWidth(const Ui& ui) { return wordWidth(ui, "Physics") + ui.px(1.0f) + listArrowWidth(ui); }
void drawPhysics(Ui& ui) {
    const PhysicsView& view = ui.workspace.physics;
    if (wordButton(ui, "Physics", view.on)) runAction(ui.workspace, "view.physics");
    ui.widgets.mark("Overlay/physics", view.on ? "on" : "off");
    tooltip(format("{} the physics layers over the scene, edited or playing  ({})", view.on ? "Hide" : "Show",
                   keysFor(ui.workspace, "view.physics")));
    ImGui::SameLine(0.0f, ui.px(1.0f));
    if (listArrow(ui, "Overlay/physics layers", ui.px(kButtonSide))) ImGui::OpenPopup("physics layers list");
    tooltip("Select the physics layers to show");
    if (!beginEdgeList(ui, "physics layers list", ImGui::GetItemRectMax().y)) return;
    physicsLayerItems(ui, "Overlay/physics/");
    ImGui::EndPopup();
}
void listPhysics(Ui& ui) {
    entry(ui, "view.physics");
    const bool open = ImGui::BeginMenu("Physics layers");
    ui.widgets.mark("Toolbar/more/Physics layers");
    if (!open) return;
    physicsLayerItems(ui, "Toolbar/more/physics/");
    ImGui::EndMenu();
}

/// The groups from left to right. Those with well-known keys, or that are also in a menu, have a lower
/// priority.
constexpr std::array kGroups{
    Group{Side::Left, 5, &width<kFile>, &drawFile, &list<kFile>, nullptr},
    Group{Side::Left, 6, &toolsWidth<false>, &drawTools<false>, &listTools<false>, &toolInHand<false>},
    Group{Side::Left, 4, &toolsWidth<true>, &drawTools<true>, &listTools<true>, &toolInHand<true>},
    Group{Side::Left, 3, &snapWidth, &drawSnap, &listSnap, nullptr},
    Group{Side::Middle, 7, &width<kRun>, &drawRun, &list<kRun>, nullptr},
    Group{Side::Right, 1, &overlaysWidth, &drawOverlays, &listOverlays, nullptr},
    Group{Side::Right, 2, &physicsWidth, &drawPhysics, &listPhysics, nullptr},
};

using Shown = std::vector<bool>;

/// Draws an arrow at the right end that opens a list of the hidden groups.
void drawMore(Ui& ui, const Shown& shown, float x) {
    ImGui::SetCursorPos({x, ui.px(kTop)});
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float side = ui.px(kButtonSide);
    bool inHand = false;
    for (std::size_t i = 0; i < kGroups.size(); ++i)
        inHand |= !shown[i] && kGroups[i].inHand != nullptr && kGroups[i].inHand(ui.workspace);
    if (inHand && ui.workspace.canEdit())
        ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + listArrowWidth(ui), at.y + side},
                                                  palette::kAccentSoft, ui.px(4.0f));
    if (listArrow(ui, "Toolbar/more", side)) ImGui::OpenPopup(kMoreList);
    tooltip("More buttons, for which the window is too narrow");
    if (!beginEdgeList(ui, kMoreList, at.y + side)) return;
    bool first = true;
    for (std::size_t i = 0; i < kGroups.size(); ++i) {
        if (shown[i]) continue;
        if (!std::exchange(first, false)) ImGui::Separator();
        kGroups[i].list(ui);
    }
    ImGui::EndPopup();
}

}  // namespace

void drawToolbar(Ui& ui, float top, float height) {
    const float window = ImGui::GetIO().DisplaySize.x;
    const float margin = ui.px(kMargin), gap = ui.px(kGap), more = listArrowWidth(ui);
    beginBar(ui, "toolbar", {0.0f, top}, {window, height}, {margin, ui.px(kTop)});
    std::array<BarGroup, kGroups.size()> groups{};
    for (std::size_t i = 0; i < groups.size(); ++i) groups[i] = {kGroups[i].width(ui), kGroups[i].worth};
    const Shown shown = shownGroups(groups, window - 2.0f * margin, gap, more);
    const bool all = std::find(shown.begin(), shown.end(), false) == shown.end();

    const auto widthOf = [&](Side side) {
        float whole = 0.0f;
        for (std::size_t i = 0; i < groups.size(); ++i) {
            if (shown[i] && kGroups[i].side == side) whole += groups[i].width + gap;
        }
        return whole;
    };
    const float end = window - margin - (all ? 0.0f : more + gap);
    const float right = end - std::max(widthOf(Side::Right) - gap, 0.0f);
    // The middle groups are centered in the window, or right of the tools if these need the center.
    const float middle = widthOf(Side::Middle) - gap;
    const float centered = std::floor((window - middle) * 0.5f);
    const float least = margin + widthOf(Side::Left);
    const float most = widthOf(Side::Right) > 0.0f ? right - gap - middle : end - middle;
    std::array<float, 3> x{margin, std::max(std::min(centered, most), least), right};
    for (std::size_t i = 0; i < groups.size(); ++i) {
        if (!shown[i]) continue;
        float& at = x[static_cast<std::size_t>(kGroups[i].side)];
        ImGui::SetCursorPos({std::floor(at), ui.px(kTop)});
        kGroups[i].draw(ui);
        at += groups[i].width + gap;
    }
    if (!all) drawMore(ui, shown, window - margin - more);
    ImGui::End();
}

}  // namespace plumb::editor::ui
