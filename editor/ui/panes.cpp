#include "editor/ui/panes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/text.hpp"
#include "editor/ui/ui_compat.hpp"

namespace plumb::editor::ui {
namespace {

// Sizes in px at scale 1.
constexpr float kTabHeight = 27.0f;
constexpr float kGap = 4.0f;         // between two panes
constexpr float kLeast = 150.0f;     // minimum width of a pane
constexpr float kTabMargin = 11.0f;  // left and right of a tab's title
constexpr float kDragStart = 8.0f;   // distance of the mouse from the press at which a tab drag starts
constexpr std::string_view kTiles = "Tiles";

struct Place {
    Dock dock;
    const char* label;
};
constexpr std::array kPlaces{Place{Dock::Left, "Left"}, Place{Dock::Right, "Right"},
                             Place{Dock::Bottom, "Bottom"}, Place{Dock::BottomRight, "Bottom right"}};

std::size_t indexOf(std::string_view title) {
    const std::span<const PanelRow> rows = panelTable();
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (title == rows[i].title) return i;
    }
    return rows.size();
}

float widthOf(const Ui& ui, std::size_t panel) {
    return std::floor(ImGui::CalcTextSize(panelTable()[panel].title).x + ui.px(2.0f * kTabMargin));
}

ImVec2 toImgui(Vec2 at) { return {at.x, at.y}; }

const char* nameOf(Edge edge) {
    switch (edge) {
        case Edge::Left: return "Splitter/left";
        case Edge::Right: return "Splitter/right";
        case Edge::Split: return "Splitter/split";
        default: return "Splitter/bottom";
    }
}

}  // namespace

Panes::Panes() {
    for (const PanelRow& row : panelTable()) panels_.push_back(row.make());
}

void Panes::draw(Ui& ui, ImVec2 from, ImVec2 size) {
    ImGui::SetNextWindowPos(from);
    ImGui::SetNextWindowSize(size);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.0f, 0.0f});
    ImGui::PushStyleColor(ImGuiCol_WindowBg, palette::kLine);
    ImGui::Begin("panes", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBringToFrontOnFocus);
    ImGui::PopStyleColor();
    ImGui::PopStyleVar();

    PaneLayout& layout = ui.workspace.settings.layout;
    layout.complete(panelHomes());
    showTilesWhilePainting(ui.workspace);
    boxes_ = arrange(layout, panelHomes(), {size.x, size.y}, ui.px(kGap), ui.px(kLeast));
    const Vec2 corner{from.x, from.y};
    for (AABB& box : boxes_.panes) box = {box.min + corner, box.max + corner};
    for (PaneBoxes::Bar& bar : boxes_.bars) bar.box = {bar.box.min + corner, bar.box.max + corner};
    tabs_.clear();
    for (std::size_t i = 0; i < kDockCount; ++i) {
        const AABB box = boxes_.panes[i];
        if (box.size().x >= 1.0f && box.size().y >= 1.0f) drawPane(ui, static_cast<Dock>(i), box);
    }
    for (const PaneBoxes::Bar& bar : boxes_.bars) drawSplitter(ui, bar);
    drawDrop(ui);
    ImGui::End();
}

void Panes::showTilesWhilePainting(Workspace& workspace) {
    PaneLayout& layout = workspace.settings.layout;
    const bool painting = workspace.paintsTiles();
    if (std::exchange(paintedTiles_, painting) == painting) return;
    if (painting) {
        openedTiles_ = !layout.isOpen(kTiles);
        beforeTiles_ = layout.pane(layout.dockOf(kTiles)).front;
        layout.show(kTiles);
    } else if (layout.pane(layout.dockOf(kTiles)).front == kTiles) {
        if (layout.isOpen(beforeTiles_)) layout.show(beforeTiles_);
        if (openedTiles_) layout.close(kTiles);
    }
}

void Panes::drawPane(Ui& ui, Dock dock, const AABB& box) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float header = ui.px(kTabHeight);
    list.AddRectFilled(toImgui(box.min), toImgui(box.max), palette::kPanel);
    list.AddRectFilled(toImgui(box.min), {box.max.x, box.min.y + header}, palette::kHeader);
    drawTabs(ui, dock, box);

    const PaneLayout::Pane& pane = ui.workspace.settings.layout.pane(dock);
    const std::size_t shown = indexOf(pane.front);
    if (shown >= panels_.size()) return;
    const bool scene = dock == Dock::Center;
    ImGui::SetCursorScreenPos({box.min.x, box.min.y + header});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding,
                        scene ? ImVec2{0.0f, 0.0f} : ImVec2{ui.px(8.0f), ui.px(8.0f)});
    ImGuiWindowFlags flags = scene ? ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse : 0;
    flags |= ImGuiWindowFlags_AlwaysUseWindowPadding;
    beginChild(panelTable()[shown].title, {box.size().x, std::max(box.size().y - header, 1.0f)}, false,
               flags);
    ImGui::PopStyleVar();
    panels_[shown]->draw(ui);
    ImGui::EndChild();
}

void Panes::drawTabs(Ui& ui, Dock dock, const AABB& box) {
    const PaneLayout::Pane pane =
        ui.workspace.settings.layout.pane(dock);  // a copy: the menu of a tab may change the layout
    const float height = ui.px(kTabHeight);
    float whole = 0.0f;
    for (const std::string& tab : pane.tabs) whole += widthOf(ui, indexOf(tab));
    const float more = whole > box.size().x ? height : 0.0f;
    const float room = box.size().x - more;
    // The front tab is always shown.
    float left = room - widthOf(ui, indexOf(pane.front));
    std::vector<std::size_t> rest;
    float x = box.min.x;
    for (const std::string& title : pane.tabs) {
        const std::size_t panel = indexOf(title);
        const float width = widthOf(ui, panel);
        const bool front = title == pane.front;
        if (!front && (width > left || !rest.empty())) {
            rest.push_back(panel);
            continue;
        }
        if (!front) left -= width;
        tabs_.push_back(
            {panel, {{x, box.min.y}, {std::min(x + width, box.min.x + room), box.min.y + height}}});
        drawTab(ui, dock, tabs_.back(), pane.tabs.size() == 1);
        x += width;
    }
    if (!rest.empty()) drawRest(ui, dock, {box.max.x - more, box.min.y}, height, rest);
}

void Panes::drawTab(Ui& ui, Dock dock, const Tab& tab, bool alone) {
    PaneLayout& layout = ui.workspace.settings.layout;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const std::string title = panelTable()[tab.panel].title;
    const bool front = layout.pane(dock).front == title;
    ImGui::SetCursorScreenPos(toImgui(tab.box.min));
    if (ImGui::InvisibleButton(title.c_str(), toImgui(tab.box.size())) && dragged_.empty())
        layout.show(title);
    ui.widgets.mark("Tab/" + title, front ? "front" : "");
    const bool hovered = ImGui::IsItemHovered();
    if (dock != Dock::Center) {
        if (hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Middle)) layout.close(title);
        dragTab(ui, title);
        tabMenu(ui, title, dock);
    }
    const ImVec2 from = toImgui(tab.box.min);
    const ImVec2 to = toImgui(tab.box.max);
    if (!alone && front) {
        list.AddRectFilled(from, to, palette::kPanel);
        list.AddRectFilled(from, {to.x, from.y + ui.px(2.0f)}, palette::kAccent);
    } else if (hovered && dock != Dock::Center) {
        list.AddRectFilled(from, to, palette::kHover);
    }
    const float top = std::floor(from.y + (to.y - from.y - ImGui::GetTextLineHeight()) * 0.5f);
    list.PushClipRect(from, to, true);
    list.AddText({std::floor(from.x + ui.px(kTabMargin)), top},
                 front || hovered ? palette::kText : palette::kTextDim, title.c_str());
    list.PopClipRect();
}

void Panes::drawRest(Ui& ui, Dock dock, ImVec2 at, float side, const std::vector<std::size_t>& rest) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const std::string id = format("Tab/more {}", static_cast<int>(dock));
    ImGui::SetCursorScreenPos(at);
    if (ImGui::InvisibleButton(id.c_str(), {side, side})) ImGui::OpenPopup((id + " list").c_str());
    ui.widgets.mark(id, format("{}", rest.size()));
    const bool hovered = ImGui::IsItemHovered();
    if (hovered) list.AddRectFilled(at, {at.x + side, at.y + side}, palette::kHover);
    const float x = at.x + side * 0.5f;
    const float y = at.y + side * 0.5f;
    const float reach = ui.px(4.0f);
    list.AddTriangleFilled({x - reach, y - reach * 0.5f}, {x + reach, y - reach * 0.5f},
                           {x, y + reach * 0.6f}, hovered ? palette::kText : palette::kTextDim);
    tooltip("More panels of this pane");
    if (!ImGui::BeginPopup((id + " list").c_str())) return;
    for (const std::size_t panel : rest) {
        const std::string title = panelTable()[panel].title;
        if (ImGui::MenuItem(title.c_str())) ui.workspace.settings.layout.show(title);
        ui.widgets.mark("Tab/" + title);
    }
    ImGui::EndPopup();
}

void Panes::tabMenu(Ui& ui, const std::string& title, Dock dock) const {
    // Opens only on a click that starts here: a drag with the right button in the scene may end over a tab.
    const std::string menu = title + " menu";
    if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) ImGui::OpenPopup(menu.c_str());
    if (!ImGui::BeginPopup(menu.c_str())) return;
    PaneLayout& layout = ui.workspace.settings.layout;
    ImGui::TextDisabled("Move to");
    for (const Place& place : kPlaces) {
        const bool chosen = ImGui::MenuItem(place.label, nullptr, place.dock == dock, place.dock != dock);
        ui.widgets.mark(format("Tab/{}/{}", title, place.label));
        if (chosen) layout.move(title, place.dock);
    }
    ImGui::Separator();
    const bool close = ImGui::MenuItem("Close");
    ui.widgets.mark(format("Tab/{}/Close", title));
    if (close) {
        layout.close(title);
        ui.workspace.notice = format("Closed {}; View > Panels opens it again", title);
    }
    ImGui::EndPopup();
}

void Panes::dragTab(Ui& ui, const std::string& title) {
    if (ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left, ui.px(kDragStart)))
        dragged_ = title;
}

/// Draws a bar between panes and handles its drag. The sizes are stored as ratios of the window's size.
void Panes::drawSplitter(Ui& ui, const PaneBoxes::Bar& bar) {
    const auto extent = [&](Dock dock) {
        const Vec2 size = boxes_.panes[static_cast<std::size_t>(dock)].size();
        return bar.upright ? size.x : size.y;
    };
    const Dock below = extent(Dock::Bottom) > 0.0f ? Dock::Bottom : Dock::BottomRight;
    Dock first = Dock::Center;
    Dock second = Dock::Center;
    switch (bar.edge) {
        case Edge::Left: first = Dock::Left; break;
        case Edge::Right: second = Dock::Right; break;
        case Edge::Split: first = Dock::Bottom, second = Dock::BottomRight; break;
        default: second = below;
    }
    float before = extent(first);
    float after = extent(second);
    const float least = ui.px(bar.upright ? kLeast : kLeast * 0.5f);
    const bool held = splitterBar(nameOf(bar.edge), toImgui(bar.box.min), toImgui(bar.box.max), bar.upright,
                                  before, after, std::min(least, std::min(before, after)));
    ui.widgets.mark(nameOf(bar.edge), bar.box);
    if (!held) return;
    const ImVec2 window = ImGui::GetWindowSize();
    const float part = bar.edge == Edge::Split  ? before / (before + after)
                       : second == Dock::Center ? before / window.x
                       : bar.upright            ? after / window.x
                                                : after / window.y;
    ui.workspace.settings.layout.resize(bar.edge, part);
}

void Panes::drawDrop(Ui& ui) {
    if (dragged_.empty()) return;
    PaneLayout& layout = ui.workspace.settings.layout;
    const ImVec2 mouse = ImGui::GetMousePos();
    const Vec2 at{mouse.x, mouse.y};
    const auto drop = dropAt(layout, boxes_, at);
    std::size_t before = ~std::size_t{0};
    ImDrawList& list = *ImGui::GetForegroundDrawList();
    if (drop) {
        list.AddRectFilled(toImgui(drop->box.min), toImgui(drop->box.max), palette::kAccentSoft);
        outline(list, toImgui(drop->box.min), toImgui(drop->box.max), palette::kAccent, 0.0f, ui.px(2.0f));
        const std::vector<std::string>& others = layout.pane(drop->dock).tabs;
        for (const Tab& tab : tabs_) {
            const auto found = std::find(others.begin(), others.end(), panelTable()[tab.panel].title);
            if (found == others.end() || !contains(tab.box, at)) continue;
            before = static_cast<std::size_t>(found - others.begin());
            list.AddRectFilled(toImgui(tab.box.min), {tab.box.min.x + ui.px(3.0f), tab.box.max.y},
                               palette::kAccent);
        }
    }
    const ImVec2 corner{mouse.x + ui.px(12.0f), mouse.y + ui.px(8.0f)};
    const ImVec2 words = ImGui::CalcTextSize(dragged_.c_str());
    list.AddRectFilled({corner.x - ui.px(6.0f), corner.y - ui.px(4.0f)},
                       {corner.x + words.x + ui.px(6.0f), corner.y + words.y + ui.px(4.0f)}, palette::kPopup,
                       ui.px(4.0f));
    list.AddText(corner, palette::kText, dragged_.c_str());
    if (ImGui::IsMouseDown(ImGuiMouseButton_Left)) return;
    // Dropped over its own pane, outside the tabs, the tab keeps its position.
    const bool home = drop && layout.dockOf(dragged_) == drop->dock;
    const bool onTab = before < ~std::size_t{0};
    if (home && (!onTab || layout.pane(drop->dock).tabs[before] == dragged_)) {
        layout.show(dragged_);
    } else if (drop) {
        layout.move(dragged_, drop->dock, before);
    }
    dragged_.clear();
}

}  // namespace plumb::editor::ui
