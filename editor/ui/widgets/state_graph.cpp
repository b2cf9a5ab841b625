#include "editor/ui/widgets/state_graph.hpp"

#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "editor/model/assets/state_machine_edit.hpp"
#include "editor/ui/ui_compat.hpp"
#include "math/angle.hpp"

namespace plumb::editor::ui {
namespace {

using Kind = MachinePart::Kind;

constexpr int kAny = AnimationTransition::kAnyState;
constexpr const char* kPayload = "plumb.state";  // drag payload: index of a state, or kAny
constexpr float kReach = 5.0f;                   // px at scale 1, maximum distance of a click from an arrow
constexpr float kApart = 4.0f;       // px at scale 1, offset of an arrow from the line between two states
constexpr float kNarrowest = 40.0f;  // px at scale 1, minimum width of a state
constexpr float kWidest = 92.0f;

struct Arrow {
    Vec2 from;
    Vec2 to;
    bool seen = false;
};

/// Layout of the graph, px on screen.
class GraphPlan {
public:
    GraphPlan(const Ui& ui, const AnimationSet& set, ImVec2 at, ImVec2 room)
        : set_{set},
          pixel_{ui.px(1.0f)},
          box_{ui.px(kNarrowest), ui.px(22.0f)},
          any_{ui.px(34.0f), ui.px(18.0f)} {
        for (const AnimationState& state : set.states)
            box_.x = std::max(box_.x, ImGui::CalcTextSize(state.name.c_str()).x + ui.px(18.0f));
        box_.x = std::min(box_.x, ui.px(kWidest));
        center_ = {at.x + room.x * 0.5f, at.y + room.y * 0.5f};
        radius_ = {room.x * 0.5f - box_.x * 0.5f - ui.px(6.0f), room.y * 0.5f - box_.y * 0.5f - ui.px(6.0f)};
    }

    [[nodiscard]] Vec2 sizeOf(int state) const { return state == kAny ? any_ : box_; }
    [[nodiscard]] Vec2 middleOf(int state) const {
        if (state == kAny) return center_;
        const float part = static_cast<float>(state) / static_cast<float>(set_.states.size());
        const float angle = kTau * part - kPi * 0.5f;
        return center_ + Vec2{std::cos(angle) * radius_.x, std::sin(angle) * radius_.y};
    }
    [[nodiscard]] Arrow arrowOf(int transition) const {
        const AnimationTransition& way = at(transition);
        const Vec2 from = middleOf(way.from), to = middleOf(way.to);
        const float length = distance(from, to);
        if (length < 1.0f) return {};
        const Vec2 step = (to - from) / length;
        const float start = edgeOf(sizeOf(way.from), step);
        const float end = edgeOf(sizeOf(way.to), step) + 2.0f * pixel_;
        // Arrows between the same two states are placed side by side.
        const Vec2 side = Vec2{-step.y, step.x} * (pixel_ * (kApart + 7.0f * laneOf(transition)));
        return {from + step * start + side, to - step * end + side, length > start + end + 4.0f * pixel_};
    }

private:
    [[nodiscard]] const AnimationTransition& at(int transition) const {
        return set_.transitions[static_cast<std::size_t>(transition)];
    }
    [[nodiscard]] float laneOf(int transition) const {
        float lane = 0.0f;
        for (int i = 0; i < transition; ++i)
            lane += at(i).from == at(transition).from && at(i).to == at(transition).to ? 1.0f : 0.0f;
        return lane;
    }
    /// Distance from the center of a box to its edge along a direction.
    static float edgeOf(Vec2 box, Vec2 step) {
        const float across = box.x * 0.5f / std::max(std::abs(step.x), 1e-4f);
        const float down = box.y * 0.5f / std::max(std::abs(step.y), 1e-4f);
        return std::min(across, down);
    }

    const AnimationSet& set_;
    float pixel_;
    Vec2 center_;
    Vec2 radius_;
    Vec2 box_;
    Vec2 any_;
};

float distanceTo(const Arrow& arrow, Vec2 point) {
    const Vec2 way = arrow.to - arrow.from;
    const float part = std::clamp(dot(point - arrow.from, way) / lengthSquared(way), 0.0f, 1.0f);
    return distance(arrow.from + way * part, point);
}

void drawArrow(const Ui& ui, ImDrawList& list, const Arrow& arrow, ImU32 color, float thickness) {
    const float length = distance(arrow.from, arrow.to);
    if (length < 1.0f) return;
    const Vec2 step = (arrow.to - arrow.from) / length;
    const Vec2 back = arrow.to - step * ui.px(7.0f);
    const Vec2 wing = Vec2{-step.y, step.x} * ui.px(4.0f);
    list.AddLine({arrow.from.x, arrow.from.y}, {back.x, back.y}, color, ui.px(thickness));
    list.AddTriangleFilled({arrow.to.x, arrow.to.y}, {back.x + wing.x, back.y + wing.y},
                           {back.x - wing.x, back.y - wing.y}, color);
}

/// Draws the graph in one frame and handles the mouse.
class Graph {
public:
    Graph(Ui& ui, const AnimationSet& set, MachinePart chosen, int playing, ImVec2 room)
        : ui_{ui},
          set_{set},
          chosen_{chosen},
          playing_{playing},
          at_{ImGui::GetCursorScreenPos()},
          room_{room},
          plan_{ui, set, at_, room},
          list_{*ImGui::GetWindowDrawList()} {}

    GraphInput draw() {
        const ImVec2 end{at_.x + room_.x, at_.y + room_.y};
        list_.AddRectFilled(at_, end, palette::kCanvas, ui_.px(4.0f));
        ImGui::PushClipRect(at_, end, true);
        drawArrows();
        drawBox(kAny, "any");
        for (int i = 0; i < static_cast<int>(set_.states.size()); ++i)
            drawBox(i, set_.states[static_cast<std::size_t>(i)].name);
        drawDragged();
        takeArrows();
        ImGui::PopClipRect();
        return std::move(hands_);
    }

private:
    [[nodiscard]] bool isChosen(Kind kind, int index) const { return chosen_ == MachinePart{kind, index}; }

    void drawArrows() {
        const int count = static_cast<int>(set_.transitions.size());
        for (const bool marked : {false, true}) {  // highlighted arrows are drawn last
            for (int i = 0; i < count; ++i) {
                const AnimationTransition& way = set_.transitions[static_cast<std::size_t>(i)];
                const bool here = isChosen(Kind::Transition, i);
                const bool leaves = chosen_.kind == Kind::State && way.from == chosen_.index;
                if ((here || leaves) != marked) continue;
                const Arrow arrow = plan_.arrowOf(i);
                if (!arrow.seen) continue;
                const bool others = chosen_.kind == Kind::State && way.to != chosen_.index;
                drawArrow(ui_, list_, arrow,
                          marked   ? palette::kAccent
                          : others ? palette::kBorder
                                   : palette::kTextDim,
                          here ? 2.5f : 1.5f);
                const Vec2 spot = lerp(arrow.from, arrow.to, 0.35f);  // not at the middle, where arrows cross
                const Vec2 half{ui_.px(3.0f), ui_.px(3.0f)};
                ui_.widgets.mark(format("Animation/arrow/{}", i), AABB{spot - half, spot + half},
                                 conditionsText(set_, way));
            }
        }
    }

    void drawBox(int state, const std::string& name) {
        const Vec2 size = plan_.sizeOf(state);
        const Vec2 from = plan_.middleOf(state) - size * 0.5f;
        const ImVec2 corner{from.x, from.y}, end{from.x + size.x, from.y + size.y};
        ImGui::PushID(state);
        ImGui::SetCursorScreenPos(corner);
        const bool clicked = ImGui::InvisibleButton("state", {size.x, size.y});
        ui_.widgets.mark(state == kAny ? "Animation/any" : "Animation/state/" + name,
                         state == playing_ ? "plays" : "");
        if (clicked && state != kAny) hands_.chosen = MachinePart{Kind::State, state};
        const bool hovered = ImGui::IsItemHovered();
        if (hovered && ImGui::IsMouseDoubleClicked(0)) hands_.entered = state;
        dragBox(state, name);
        const bool chosen = state != kAny && isChosen(Kind::State, state);
        if (!chosen) tooltip(helpFor(state));
        ImGui::PopID();
        const bool plays = state != kAny && state == playing_;
        list_.AddRectFilled(corner, end,
                            plays     ? palette::kChromePlaying
                            : hovered ? palette::kHeaderHovered
                                      : palette::kHeader,
                            ui_.px(4.0f));
        outline(list_, corner, end,
                chosen  ? palette::kAccent
                : plays ? palette::kPlay
                        : palette::kTextDim,
                ui_.px(4.0f), chosen ? 2.0f : 1.0f);
        if (state == 0) drawStart(from, size.y);
        const ImVec2 text = ImGui::CalcTextSize(name.c_str());
        list_.PushClipRect(corner, end, true);
        list_.AddText(
            {from.x + std::max((size.x - text.x) * 0.5f, ui_.px(7.0f)), from.y + (size.y - text.y) * 0.5f},
            state == kAny ? palette::kTextDim : palette::kText, name.c_str());
        list_.PopClipRect();
    }

    static std::string helpFor(int state) {
        if (state == kAny)
            return "Any state: drag from here to a state to add a transition from all other states";
        return format("{}Drag to another state to add a transition; double-click to play it",
                      state == 0 ? "Initial state. " : "");
    }

    /// Draws the mark of the initial state.
    void drawStart(Vec2 from, float height) {
        const float x = from.x - ui_.px(5.0f), y = from.y + height * 0.5f, arm = ui_.px(4.5f);
        list_.AddTriangleFilled({x, y - arm}, {x + arm * 1.6f, y}, {x, y + arm}, palette::kPlay);
    }

    void dragBox(int state, const std::string& name) {
        if (ImGui::BeginDragDropSource()) {
            ImGui::SetDragDropPayload(kPayload, &state, sizeof state);
            ImGui::TextUnformatted(format("{} to ...", name).c_str());
            ImGui::EndDragDropSource();
        }
        if (state == kAny || !ImGui::BeginDragDropTarget()) return;
        if (const ImGuiPayload* payload = ImGui::AcceptDragDropPayload(kPayload))
            hands_.joined = {*static_cast<const int*>(payload->Data), state};
        ImGui::EndDragDropTarget();
    }

    /// Draws the arrow of the transition being dragged.
    void drawDragged() {
        const ImGuiPayload* payload = ImGui::GetDragDropPayload();
        if (payload == nullptr || !payload->IsDataType(kPayload)) return;
        const int from = *static_cast<const int*>(payload->Data);
        if (from >= static_cast<int>(set_.states.size())) return;
        const ImVec2 mouse = ImGui::GetIO().MousePos;
        drawArrow(ui_, list_, {plan_.middleOf(from), {mouse.x, mouse.y}, true}, palette::kAccent, 2.0f);
    }

    /// Handles clicks on arrows and on the background. Called
    /// after the states, so that these get clicks first.
    void takeArrows() {
        ImGui::SetCursorScreenPos(at_);
        const bool clicked = ImGui::InvisibleButton("canvas", room_);
        ui_.widgets.mark("Animation/graph");
        if (!ImGui::IsItemHovered()) return;
        const ImVec2 mouse = ImGui::GetIO().MousePos;
        int nearest = -1;
        float closest = ui_.px(kReach);
        for (int i = 0; i < static_cast<int>(set_.transitions.size()); ++i) {
            const Arrow arrow = plan_.arrowOf(i);
            const float away = arrow.seen ? distanceTo(arrow, {mouse.x, mouse.y}) : closest;
            if (away < closest) closest = away, nearest = i;
        }
        if (clicked) hands_.chosen = nearest < 0 ? MachinePart{} : MachinePart{Kind::Transition, nearest};
        if (nearest < 0) return;
        const AnimationTransition& way = set_.transitions[static_cast<std::size_t>(nearest)];
        if (!isChosen(Kind::Transition, nearest))
            drawArrow(ui_, list_, plan_.arrowOf(nearest), palette::kText, 2.0f);
        tooltip(format("{}: {}", transitionText(set_, way), conditionsText(set_, way)));
    }

    Ui& ui_;
    const AnimationSet& set_;
    MachinePart chosen_;
    int playing_;
    ImVec2 at_;
    ImVec2 room_;
    GraphPlan plan_;
    ImDrawList& list_;
    GraphInput hands_;
};

}  // namespace

GraphInput drawStateGraph(Ui& ui, const AnimationSet& set, MachinePart chosen, int playing, ImVec2 room) {
    return Graph{ui, set, chosen, playing, room}.draw();
}

}  // namespace plumb::editor::ui
