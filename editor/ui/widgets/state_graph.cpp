#include "editor/ui/widgets/state_graph.hpp"

#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "editor/ui/ui_compat.hpp"
#include "math/angle.hpp"

namespace plumb::editor::ui {
namespace {

constexpr std::array kComparisons{">", "<", ">=", "<=", "==", "!="};

Vec2 placeOf(int state, int count, Vec2 center, Vec2 radius) {
    const float angle =
        kTau * static_cast<float>(state) / static_cast<float>(std::max(count, 1)) - kPi * 0.5f;
    return center + (count < 2 ? Vec2{} : Vec2{std::cos(angle) * radius.x, std::sin(angle) * radius.y});
}

void drawArrow(ImDrawList& list, Vec2 from, Vec2 to, float shorten, ImU32 color) {
    const Vec2 way = to - from;
    const float length = std::sqrt(way.x * way.x + way.y * way.y);
    if (length < shorten * 2.0f + 1.0f) return;
    const Vec2 step = way / length;
    const Vec2 side{-step.y, step.x};
    // Two ways between the same boxes lie beside each other.
    const Vec2 a = from + step * shorten + side * 4.0f;
    const Vec2 b = to - step * shorten + side * 4.0f;
    list.AddLine({a.x, a.y}, {b.x, b.y}, color, 1.5f);
    const Vec2 back = b - step * 7.0f;
    list.AddTriangleFilled({b.x, b.y}, {back.x + side.x * 4.0f, back.y + side.y * 4.0f},
                           {back.x - side.x * 4.0f, back.y - side.y * 4.0f}, color);
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
    const ImVec2 room{ImGui::GetContentRegionAvail().x,
                      std::max(ImGui::GetContentRegionAvail().y * 0.6f, ui.px(90.0f))};
    const Vec2 box{ui.px(68.0f), ui.px(22.0f)};
    const Vec2 center{at.x + room.x * 0.5f, at.y + room.y * 0.5f};
    const Vec2 radius{room.x * 0.5f - box.x * 0.55f, room.y * 0.5f - box.y * 0.8f};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(at, {at.x + room.x, at.y + room.y}, palette::kCanvas);
    for (const AnimationTransition& transition : set.transitions) {
        const Vec2 to = placeOf(transition.to, count, center, radius);
        const Vec2 from = transition.from < 0 ? center : placeOf(transition.from, count, center, radius);
        drawArrow(list, from, to, transition.from < 0 ? 0.0f : box.y, palette::kTextDim);
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
    ImGui::SetCursorScreenPos({at.x, at.y + room.y + ui.px(4.0f)});
    drawTransitions(ui, edit);
}

}  // namespace plumb::editor::ui
