#include "editor/model/view/layout.hpp"

#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "reflect/json.hpp"
#include "reflect/json_fields.hpp"
#include "reflect/json_members.hpp"

namespace plumb::editor {
namespace {

constexpr std::array<std::string_view, kDockCount> kDockNames{"left", "center", "right", "bottom",
                                                              "bottomRight"};
constexpr std::array<std::string_view, kEdgeCount> kEdgeNames{"left", "right", "bottom", "tallBottom",
                                                              "split"};
constexpr float kLeastPart = 0.08f;
constexpr float kMostPart = 0.6f;
constexpr std::size_t kMostTabs = 64;

bool holds(const std::vector<std::string>& tabs, std::string_view panel) {
    return std::find(tabs.begin(), tabs.end(), panel) != tabs.end();
}

}  // namespace

void PaneLayout::complete(std::span<const PanelHome> panels) {
    const auto known = [&](std::string_view title) {
        return std::any_of(panels.begin(), panels.end(),
                           [&](const PanelHome& home) { return home.title == title; });
    };
    const bool empty =
        std::all_of(panes_.begin(), panes_.end(), [](const Pane& pane) { return pane.tabs.empty(); });
    std::vector<std::string> seen;
    for (std::size_t i = 0; i < kDockCount; ++i) {
        const bool center = static_cast<Dock>(i) == Dock::Center;
        std::erase_if(panes_[i].tabs, [&](const std::string& tab) {
            const bool stays = !center && known(tab) && !holds(seen, tab);
            if (stays) seen.push_back(tab);
            return !stays;
        });
    }
    std::erase_if(closed_, [&](const Closed& closed) {
        const bool stays = known(closed.panel) && !holds(seen, closed.panel);
        if (stays) seen.push_back(closed.panel);
        return !stays;
    });
    for (const PanelHome& home : panels) {
        if (home.dock == Dock::Center) take(home.title);
        if (home.dock != Dock::Center && holds(seen, home.title)) continue;
        // A pane that the user emptied stays empty.
        const bool cleared = !empty && home.dock != Dock::Center && pane(home.dock).tabs.empty();
        at(cleared ? Dock::Bottom : home.dock).tabs.emplace_back(home.title);
    }
    for (Pane& pane : panes_) {
        if (!holds(pane.tabs, pane.front)) pane.front = pane.tabs.empty() ? std::string{} : pane.tabs.front();
    }
}

bool PaneLayout::isOpen(std::string_view panel) const {
    return std::any_of(panes_.begin(), panes_.end(),
                       [&](const Pane& pane) { return holds(pane.tabs, panel); });
}

Dock PaneLayout::dockOf(std::string_view panel) const {
    for (std::size_t i = 0; i < kDockCount; ++i) {
        if (holds(panes_[i].tabs, panel)) return static_cast<Dock>(i);
    }
    for (const Closed& closed : closed_) {
        if (closed.panel == panel) return closed.dock;
    }
    return Dock::Bottom;
}

bool PaneLayout::isSeen(std::string_view panel) const {
    return !hidden && isOpen(panel) && pane(dockOf(panel)).front == panel;
}

void PaneLayout::show(std::string_view panel) {
    const Dock dock = dockOf(panel);
    if (!isOpen(panel)) {
        take(panel);
        at(dock).tabs.emplace_back(panel);
    }
    at(dock).front = panel;
}

void PaneLayout::close(std::string_view panel) {
    const Dock dock = dockOf(panel);
    if (dock == Dock::Center || !isOpen(panel)) return;
    const std::string title{panel};  // a copy: `panel` may refer to the list that is changed
    take(title);
    closed_.push_back({title, dock});
}

void PaneLayout::move(std::string_view panel, Dock to, std::size_t before) {
    if (dockOf(panel) == Dock::Center || to == Dock::Center) return;
    const std::string title{panel};
    take(title);
    std::vector<std::string>& tabs = at(to).tabs;
    tabs.insert(tabs.begin() + static_cast<std::ptrdiff_t>(std::min(before, tabs.size())), title);
    at(to).front = title;
}

/// If the removed tab was in front, the tab beside it comes to the front.
void PaneLayout::take(std::string_view panel) {
    std::erase_if(closed_, [&](const Closed& closed) { return closed.panel == panel; });
    for (Pane& pane : panes_) {
        const auto found = std::find(pane.tabs.begin(), pane.tabs.end(), panel);
        if (found == pane.tabs.end()) continue;
        const bool inFront = pane.front == panel;
        const auto index = static_cast<std::size_t>(found - pane.tabs.begin());
        pane.tabs.erase(found);
        if (pane.tabs.empty()) {
            pane.front.clear();
        } else if (inFront) {
            pane.front = pane.tabs[std::min(index, pane.tabs.size() - 1)];
        }
    }
}

void PaneLayout::resize(Edge edge, float part) {
    if (std::isfinite(part))
        sizes_[static_cast<std::size_t>(edge)] = std::clamp(part, kLeastPart, 1.0f - kLeastPart);
}

Json PaneLayout::toJson() const {
    Json json = Json::object();
    Json fronts = Json::object();
    for (std::size_t i = 0; i < kDockCount; ++i) {
        if (static_cast<Dock>(i) == Dock::Center) continue;
        const std::string dock{kDockNames[i]};
        json[dock] = panes_[i].tabs;
        if (!panes_[i].front.empty()) fronts[dock] = panes_[i].front;
    }
    json["front"] = std::move(fronts);
    Json closed = Json::object();
    for (const Closed& one : closed_) {
        closed[one.panel] = kDockNames[static_cast<std::size_t>(one.dock)];
    }
    json["closed"] = std::move(closed);
    Json sizes = Json::object();
    for (std::size_t i = 0; i < kEdgeCount; ++i) {
        sizes[std::string{kEdgeNames[i]}] = sizes_[i];
    }
    json["sizes"] = std::move(sizes);
    return json;
}

std::optional<PaneLayout> PaneLayout::fromJson(const Json& json, const std::string& where,
                                               std::vector<Error>& problems) {
    if (!json.is_object()) {
        problems.push_back(
            {where, format("expected a layout, found {}", json.type_name()), "the default layout is used"});
        return std::nullopt;
    }
    PaneLayout layout;
    JsonFields fields{json, where, problems};
    const Json* fronts = fields.find("front");
    for (std::size_t i = 0; i < kDockCount; ++i) {
        const Json* tabs = fields.array(kDockNames[i]);
        for (std::size_t t = 0; tabs != nullptr && t < std::min(tabs->size(), kMostTabs); ++t) {
            const Json& tab = (*tabs)[t];
            if (const std::string* name = jsonText(tab)) {
                layout.panes_[i].tabs.push_back(*name);
            } else {
                fields.warn(kDockNames[i], format("expected the name of a panel, found {}", tab.type_name()),
                            "this entry is ignored");
            }
        }
        const std::string* front = fronts == nullptr ? nullptr : findText(*fronts, kDockNames[i]);
        if (front != nullptr) layout.panes_[i].front = *front;
    }
    if (const Json* closed = fields.find("closed"); closed != nullptr && closed->is_object()) {
        for (const auto& [panel, from] : closed->items()) {
            const auto name = std::find(kDockNames.begin(), kDockNames.end(), stringOrEmpty(from));
            const auto dock =
                name == kDockNames.end() ? Dock::Bottom : static_cast<Dock>(name - kDockNames.begin());
            layout.closed_.push_back({panel, dock == Dock::Center ? Dock::Bottom : dock});
        }
    }
    if (const Json* sizes = fields.find("sizes"); sizes != nullptr) {
        JsonFields parts{*sizes, where + ".sizes", problems};
        for (std::size_t i = 0; i < kEdgeCount; ++i) {
            layout.sizes_[i] = parts.number(kEdgeNames[i], layout.sizes_[i], kLeastPart, 1.0f - kLeastPart);
        }
    }
    return layout;
}

std::vector<LayoutPreset> makePresets() {
    PaneLayout paint;
    paint.at(Dock::Left).tabs = {"Scene", "Inspector"};
    paint.at(Dock::Bottom).tabs = {"Tiles", "Tileset", "Assets"};
    paint.sizes_ = {0.2f, 0.24f, 0.22f, 0.42f, 0.5f};

    PaneLayout logic;
    logic.at(Dock::Bottom).front = "Console";

    PaneLayout play;
    play.at(Dock::Right).tabs = {"Inspector", "Scene"};
    play.at(Dock::Bottom).tabs = {"Console"};
    play.at(Dock::BottomRight).tabs = {"History"};
    play.sizes_ = {0.18f, 0.26f, 0.2f, 0.2f, 0.6f};

    return {{"Paint", "tiles at the bottom at full width; entities and inspector share the left", paint},
            {"Logic", "entities on the left, inspector on the right, the other panels at the bottom", logic},
            {"Play", "the game as large as possible, with the inspector beside it", play}};
}

std::span<const LayoutPreset> layoutPresets() {
    static const std::vector<LayoutPreset> presets = makePresets();
    return presets;
}

PaneBoxes arrange(const PaneLayout& layout, std::span<const PanelHome> panels, Vec2 size, float gap,
                  float least) {
    PaneBoxes boxes;
    const auto there = [&](Dock dock) { return !layout.hidden && !layout.pane(dock).tabs.empty(); };
    // Any tall tab counts, not only the front one, so that the layout does not jump when another tab is
    // clicked.
    const auto tall = [&](Dock dock) {
        return there(dock) && std::any_of(panels.begin(), panels.end(), [&](const PanelHome& home) {
                   return home.tall && holds(layout.pane(dock).tabs, home.title);
               });
    };
    // Limits the size of panes, so that the scene always has room, even in a small window.
    const auto part = [&](float whole, float ratio) {
        const float most = std::floor(whole * kMostPart * 0.75f);
        return std::min(std::max(std::floor(whole * ratio), std::min(least, most)), most);
    };
    const float left = there(Dock::Left) ? part(size.x, layout.size(Edge::Left)) : 0.0f;
    const float right = there(Dock::Right) ? part(size.x, layout.size(Edge::Right)) : 0.0f;
    const Edge bottomEdge = tall(Dock::Bottom) || tall(Dock::BottomRight) ? Edge::TallBottom : Edge::Bottom;
    const bool below = there(Dock::Bottom) || there(Dock::BottomRight);
    const float bottom = below
                             ? std::min(std::max(std::floor(size.y * layout.size(bottomEdge)), least * 0.5f),
                                        std::floor(size.y * 0.7f))
                             : 0.0f;
    const float x0 = left > 0.0f ? left + gap : 0.0f;
    const float x1 = right > 0.0f ? size.x - right - gap : size.x;
    const float y1 = below ? size.y - bottom - gap : size.y;
    const auto put = [&](Dock dock, AABB box) { boxes.panes[static_cast<std::size_t>(dock)] = box; };
    if (left > 0.0f) {
        put(Dock::Left, {{0.0f, 0.0f}, {left, size.y}});
        boxes.bars.push_back({Edge::Left, {{left, 0.0f}, {x0, size.y}}, true});
    }
    if (right > 0.0f) {
        put(Dock::Right, {{size.x - right, 0.0f}, size});
        boxes.bars.push_back({Edge::Right, {{x1, 0.0f}, {size.x - right, size.y}}, true});
    }
    put(Dock::Center, {{x0, 0.0f}, {x1, y1}});
    if (!below) return boxes;
    boxes.bars.push_back({bottomEdge, {{x0, y1}, {x1, y1 + gap}}, false});
    const float y2 = y1 + gap;
    if (!there(Dock::Bottom) || !there(Dock::BottomRight)) {
        put(there(Dock::Bottom) ? Dock::Bottom : Dock::BottomRight, {{x0, y2}, {x1, size.y}});
        return boxes;
    }
    const float split = x0 + std::floor((x1 - x0) * layout.size(Edge::Split));
    put(Dock::Bottom, {{x0, y2}, {split, size.y}});
    put(Dock::BottomRight, {{split + gap, y2}, {x1, size.y}});
    boxes.bars.push_back({Edge::Split, {{split, y2}, {split + gap, size.y}}, true});
    return boxes;
}

std::optional<PaneDrop> dropAt(const PaneLayout& layout, const PaneBoxes& boxes, Vec2 at) {
    const auto boxOf = [&](Dock dock) { return boxes.panes[static_cast<std::size_t>(dock)]; };
    const auto there = [&](Dock dock) { return !layout.pane(dock).tabs.empty(); };
    for (const Dock dock : {Dock::Left, Dock::Right, Dock::BottomRight, Dock::Bottom}) {
        const AABB box = boxOf(dock);
        if (!there(dock) || !contains(box, at)) continue;
        const bool bottom = dock == Dock::Bottom || dock == Dock::BottomRight;
        const Dock other = dock == Dock::Bottom ? Dock::BottomRight : Dock::Bottom;
        if (!bottom || there(other)) return PaneDrop{dock, box};
        // The bottom is not divided yet: dropping on its outer part divides it.
        const float middle = lerp(box.min, box.max, other == Dock::BottomRight ? 0.6f : 0.4f).x;
        const AABB right{{middle, box.min.y}, box.max};
        const AABB left{box.min, {middle, box.max.y}};
        if (other == Dock::BottomRight && at.x >= middle) return PaneDrop{other, right};
        if (other == Dock::Bottom && at.x < middle) return PaneDrop{other, left};
        return PaneDrop{dock, box};
    }
    const AABB scene = boxOf(Dock::Center);
    if (!contains(scene, at)) return std::nullopt;
    const Vec2 part = {(at.x - scene.min.x) / scene.size().x, (at.y - scene.min.y) / scene.size().y};
    const Vec2 inner = lerp(scene.min, scene.max, 0.25f);
    const Vec2 outer = lerp(scene.min, scene.max, 0.75f);
    if (part.x < 0.25f && !there(Dock::Left))
        return PaneDrop{Dock::Left, {scene.min, {inner.x, scene.max.y}}};
    if (part.x > 0.75f && !there(Dock::Right))
        return PaneDrop{Dock::Right, {{outer.x, scene.min.y}, scene.max}};
    if (part.y > 0.75f && !there(Dock::Bottom) && !there(Dock::BottomRight))
        return PaneDrop{Dock::Bottom, {{scene.min.x, outer.y}, scene.max}};
    return std::nullopt;
}

}  // namespace plumb::editor
