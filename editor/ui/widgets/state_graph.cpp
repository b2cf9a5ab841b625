#include "editor/ui/widgets/state_graph.hpp"

#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "editor/ui/ui_compat.hpp"
#include "math/angle.hpp"

namespace plumb::editor::ui {
namespace {

constexpr float kBeside = 380.0f;  // px at scale 1
constexpr std::array kComparisons{">", "<", ">=", "<=", "==", "!="};

Vec2 placeOf(int state, int count, Vec2 center, Vec2 radius) {
    const float angle =
        kTau * static_cast<float>(state) / static_cast<float>(std::max(count, 1)) - kPi * 0.5f;
    return center + (count < 2 ? Vec2{} : Vec2{std::cos(angle) * radius.x, std::sin(angle) * radius.y});
}

/// How far the edge of a box lies from its middle, along a way.
float edgeOf(Vec2 box, Vec2 step) {
    const float across = box.x * 0.5f / std::max(std::abs(step.x), 1e-4f);
    const float down = box.y * 0.5f / std::max(std::abs(step.y), 1e-4f);
    return std::min(across, down);
}

/// From one box to another. @param leave  the box that it begins at; none: it begins at a point
void drawArrow(const Ui& ui, ImDrawList& list, Vec2 from, Vec2 to, Vec2 leave, Vec2 reach, ImU32 color) {
    const Vec2 way = to - from;
    const float length = std::sqrt(way.x * way.x + way.y * way.y);
    if (length < 1.0f) return;
    const Vec2 step = way / length;
    const float start = edgeOf(leave, step);
    const float end = edgeOf(reach, step) + ui.px(2.0f);
    if (length < start + end + ui.px(4.0f)) return;
    const Vec2 side{-step.y, step.x};
    // Two ways between the same boxes lie beside each other.
    const Vec2 a = from + step * start + side * ui.px(4.0f);
    const Vec2 b = to - step * end + side * ui.px(4.0f);
    list.AddLine({a.x, a.y}, {b.x, b.y}, color, ui.px(1.5f));
    const Vec2 back = b - step * ui.px(7.0f);
    const Vec2 wing = side * ui.px(4.0f);
    list.AddTriangleFilled({b.x, b.y}, {back.x + wing.x, back.y + wing.y}, {back.x - wing.x, back.y - wing.y},
                           color);
}

/// "after its end, speed > 1"
std::string whenText(const AnimationSet& set, const AnimationTransition& transition) {
    std::string text = transition.afterEnd ? "after its end" : "";
    for (const AnimationCondition& condition : transition.when) {
        if (!text.empty()) text += ", ";
        text += format("{} {} {}", set.parameters[static_cast<std::size_t>(condition.parameter)].name,
                       kComparisons[static_cast<std::size_t>(condition.is)], condition.value);
    }
    return text.empty() ? "at once" : text;
}

void drawTransitions(Ui& ui, AnimationEdit& edit) {
    const AnimationSet set = edit.set();
    const auto nameOf = [&](int state) {
        return state == AnimationTransition::kAnyState ? std::string{"any"}
                                                       : set.states[static_cast<std::size_t>(state)].name;
    };
    for (int i = 0; i < static_cast<int>(set.transitions.size()); ++i) {
        const AnimationTransition& transition = set.transitions[static_cast<std::size_t>(i)];
        ImGui::PushID(i);
        ImGui::Selectable(
            format("{} > {}: {}", nameOf(transition.from), nameOf(transition.to), whenText(set, transition))
                .c_str());
        ui.widgets.mark(format("Animation/transition/{}", i));
        tooltip("A right click takes it out");
        if (ImGui::IsItemClicked(1)) edit.removeTransition(i);
        ImGui::PopID();
    }
}

}  // namespace

void drawStateGraph(Ui& ui, AnimationEdit& edit, int clip, int& state) {
    const AnimationSet set = edit.set();
    const int count = static_cast<int>(set.states.size());
    if (ImGui::SmallButton("Add state")) edit.addState(clip);
    ui.widgets.mark("Animation/addState");
    tooltip("A state that plays the selected clip");
    ImGui::SameLine();
    if (ImGui::SmallButton("Remove") && state >= 0) edit.removeState(std::exchange(state, -1));
    ui.widgets.mark("Animation/removeState");
    if (count == 0) {
        ImGui::TextWrapped("Without states the game chooses clips by hand.");
        return;
    }
    const ImVec2 at = ImGui::GetCursorScreenPos();
    // The transitions stand beside the states, or below them where that is too narrow.
    const ImVec2 all = ImGui::GetContentRegionAvail();
    const bool wide = all.x >= ui.px(kBeside);
    const ImVec2 room{wide ? std::floor(all.x * 0.6f) : all.x,
                      wide ? std::max(all.y, ui.px(90.0f)) : std::max(all.y * 0.6f, ui.px(90.0f))};
    const Vec2 box{ui.px(68.0f), ui.px(22.0f)};
    const Vec2 center{at.x + room.x * 0.5f, at.y + room.y * 0.5f};
    const Vec2 radius{room.x * 0.5f - box.x * 0.55f, room.y * 0.5f - box.y * 0.8f};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(at, {at.x + room.x, at.y + room.y}, palette::kCanvas);
    for (const AnimationTransition& transition : set.transitions) {
        const Vec2 to = placeOf(transition.to, count, center, radius);
        const Vec2 from = transition.from < 0 ? center : placeOf(transition.from, count, center, radius);
        drawArrow(ui, list, from, to, transition.from < 0 ? Vec2{} : box, box, palette::kTextDim);
    }
    for (int i = 0; i < count; ++i) {
        const std::string& name = set.states[static_cast<std::size_t>(i)].name;
        const Vec2 place = placeOf(i, count, center, radius) - box * 0.5f;
        ImGui::PushID(i);
        ImGui::SetCursorScreenPos({place.x, place.y});
        if (ImGui::InvisibleButton("state", {box.x, box.y})) state = i;
        ui.widgets.mark("Animation/state/" + name);
        if (ImGui::BeginDragDropSource()) {
            ImGui::SetDragDropPayload("state", &i, sizeof i);
            ImGui::TextUnformatted("To the next state");
            ImGui::EndDragDropSource();
        }
        if (ImGui::BeginDragDropTarget()) {
            if (const ImGuiPayload* payload = ImGui::AcceptDragDropPayload("state"))
                edit.addTransition(*static_cast<const int*>(payload->Data), i);
            ImGui::EndDragDropTarget();
        }
        tooltip(i == 0 ? "It begins here. Drag to another state for a transition."
                       : "Drag to another state for a transition.");
        ImGui::PopID();
        list.AddRectFilled({place.x, place.y}, {place.x + box.x, place.y + box.y}, palette::kHeader,
                           ui.px(4.0f));
        outline(list, {place.x, place.y}, {place.x + box.x, place.y + box.y},
                i == state ? palette::kAccent
                : i == 0   ? palette::kPlay
                           : palette::kTextDim,
                ui.px(4.0f));
        const ImVec2 size = ImGui::CalcTextSize(name.c_str());
        list.PushClipRect({place.x, place.y}, {place.x + box.x, place.y + box.y}, true);
        list.AddText({place.x + std::max((box.x - size.x) * 0.5f, 3.0f), place.y + (box.y - size.y) * 0.5f},
                     palette::kText, name.c_str());
        list.PopClipRect();
    }
    ImGui::SetCursorScreenPos(wide ? ImVec2{at.x + room.x + ui.px(10.0f), at.y}
                                   : ImVec2{at.x, at.y + room.y + ui.px(4.0f)});
    beginChild("transitions", {0.0f, wide ? room.y : 0.0f}, false);
    drawTransitions(ui, edit);
    ImGui::EndChild();
}

}  // namespace plumb::editor::ui
