#include "editor/ui/panels/machine_details.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "core/text.hpp"
#include "editor/ui/ui_compat.hpp"

namespace plumb::editor::ui {
namespace {

using Kind = MachinePart::Kind;

constexpr float kLabelWidth = 50.0f;   // px at scale 1
constexpr float kSignWidth = 52.0f;    // px at scale 1
constexpr float kValueWidth = 50.0f;   // px at scale 1
constexpr float kRemoveWidth = 20.0f;  // px at scale 1
constexpr std::array kKinds{"number", "on or off", "trigger"};
constexpr std::size_t kComparisons = 6;

template <class T>
const T& at(const std::vector<T>& items, int index) {
    return items[static_cast<std::size_t>(index)];
}

/// Draws the name of the selected part and, at the right, the button that removes it.
void drawTitle(Ui& ui, StateMachineEdit& edit, MachinePart& chosen, const std::string& title) {
    const float right = ImGui::GetWindowContentRegionMax().x - ui.px(62.0f);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = std::max(right - ImGui::GetCursorPosX() - ui.px(6.0f), 1.0f);
    pushFont(ui.fonts.strong, ui.fonts.size);
    ImGui::PushClipRect(at, {at.x + width, at.y + ImGui::GetFrameHeight()}, true);
    ImGui::TextUnformatted(title.c_str());
    ImGui::PopClipRect();
    ImGui::PopFont();
    ui.widgets.mark("Animation/chosen", title);
    tooltip(title);
    ImGui::SameLine(right);
    if (ImGui::SmallButton("Remove")) removePart(edit, chosen);
    ui.widgets.mark("Animation/remove");
}

void drawLabel(const Ui& ui, const char* label) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("%s", label);
    ImGui::SameLine(ui.px(kLabelWidth));
    ImGui::SetNextItemWidth(-1.0f);
}

/// Draws a combo box of names. @return the index that was selected, if it differs from `now`
template <class NameOf>
std::optional<int> chooseName(Ui& ui, const std::string& path, int now, int count, const char* shown,
                              const NameOf& nameOf) {
    const bool open = ImGui::BeginCombo(("##" + path).c_str(), shown);
    ui.widgets.mark(path, shown);
    if (!open) return std::nullopt;
    std::optional<int> chosen;
    for (int i = 0; i < count; ++i) {
        const std::string name = nameOf(i);
        ImGui::PushID(i);
        if (ImGui::Selectable(name.c_str(), i == now) && i != now) chosen = i;
        ImGui::PopID();
        ui.widgets.mark(format("{}/{}", path, name));
    }
    ImGui::EndCombo();
    return chosen;
}

/// Draws a line for each transition that the filter `wanted` accepts; a click selects the transition.
template <class Wanted>
void listTransitions(Ui& ui, const AnimationSet& set, MachinePart& chosen, const Wanted& wanted) {
    for (int i = 0; i < static_cast<int>(set.transitions.size()); ++i) {
        const AnimationTransition& transition = at(set.transitions, i);
        if (!wanted(transition)) continue;
        const std::string text =
            format("{}: {}", transitionText(set, transition), conditionsText(set, transition));
        ImGui::PushID(i);
        if (ImGui::Selectable(text.c_str())) chosen = {Kind::Transition, i};
        ImGui::PopID();
        ui.widgets.mark(format("Animation/transition/{}", i), text);
        tooltip(text);
    }
}

void drawOrder(Ui& ui, StateMachineEdit& edit, MachinePart& chosen) {
    const auto count = static_cast<int>(edit.set().transitions.size());
    int by = 0;
    ImGui::BeginDisabled(chosen.index == 0);
    if (ImGui::ArrowButton("earlier", ImGuiDir_Up)) by = -1;
    ui.widgets.mark("Animation/earlier");
    ImGui::EndDisabled();
    tooltip("Moves this transition up. If several transitions are possible, the first one is taken");
    ImGui::SameLine(0.0f, ui.px(3.0f));
    ImGui::BeginDisabled(chosen.index + 1 == count);
    if (ImGui::ArrowButton("later", ImGuiDir_Down)) by = 1;
    ui.widgets.mark("Animation/later");
    ImGui::EndDisabled();
    tooltip("Moves this transition down");
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("priority %d of %d", chosen.index + 1, count);
    if (by != 0) chosen.index = edit.moveTransition(chosen.index, by);
}

/// Draws the button that adds a condition, with a menu of the parameters.
void drawAddCondition(Ui& ui, StateMachineEdit& edit, int transition) {
    const AnimationSet& set = edit.set();
    const bool full = at(set.transitions, transition).when.size() >= StateMachineEdit::kMaxConditions;
    ImGui::BeginDisabled(set.parameters.empty() || full);
    if (ImGui::Button("Add condition")) ImGui::OpenPopup("add condition");
    ui.widgets.mark("Animation/addCondition");
    ImGui::EndDisabled();
    tooltip(set.parameters.empty() ? "A condition tests a parameter: add a parameter on the left first"
                                   : "The transition is taken only if all of its conditions hold");
    if (!ImGui::BeginPopup("add condition")) return;
    int wanted = -1;
    for (int i = 0; i < static_cast<int>(set.parameters.size()); ++i) {
        const std::string& name = at(set.parameters, i).name;
        if (ImGui::MenuItem(name.c_str())) wanted = i;
        ui.widgets.mark("Animation/addCondition/" + name);
    }
    ImGui::EndPopup();
    if (wanted >= 0) edit.addCondition(transition, wanted);
}

}  // namespace

void MachineDetails::draw(Ui& ui, StateMachineEdit& edit, MachinePart& chosen) {
    switch (chosen.kind) {
        case Kind::State: return drawState(ui, edit, chosen);
        case Kind::Transition: return drawTransition(ui, edit, chosen);
        case Kind::Parameter: return drawParameter(ui, edit, chosen);
        case Kind::None: break;
    }
    const AnimationSet set = edit.set();
    ImGui::TextDisabled("Transitions");
    tooltip("If several transitions are possible, the first one is taken. Click one to edit its conditions");
    if (set.transitions.empty()) ImGui::TextWrapped("Drag from one state to another to add a transition.");
    listTransitions(ui, set, chosen, [](const AnimationTransition&) { return true; });
}

void MachineDetails::drawState(Ui& ui, StateMachineEdit& edit, MachinePart& chosen) {
    const AnimationSet set = edit.set();  // a copy, as an edit replaces the set
    const int state = chosen.index;
    const AnimationState& now = at(set.states, state);
    drawTitle(ui, edit, chosen, "State " + now.name);
    drawLabel(ui, "Name");
    if (const auto name = text_.draw(ui, "Animation/stateName", now.name)) edit.renameState(state, *name);
    drawLabel(ui, "Clip");
    const auto clipName = [&](int i) { return at(set.clips, i).name; };
    if (const auto clip = chooseName(ui, "Animation/stateClip", now.clip, static_cast<int>(set.clips.size()),
                                     clipName(now.clip).c_str(), clipName))
        edit.setClip(state, *clip);
    drawLabel(ui, "Speed");
    if (const auto speed = number_.draw(ui, "Animation/stateSpeed", now.speed, 0.01f, "%.4g"))
        edit.setSpeed(state, *speed);
    tooltip("1 plays at the speed of the clip, 2 twice as fast; negative plays backwards");
    drawLabel(ui, "Goes to");
    const auto stateName = [&](int i) { return at(set.states, i).name; };
    if (const auto to = chooseName(ui, "Animation/to", state, static_cast<int>(set.states.size()),
                                   "Add a transition to ...", stateName)) {
        edit.addTransition(state, *to);
        if (edit.set().transitions.size() > set.transitions.size())
            chosen = {Kind::Transition, static_cast<int>(set.transitions.size())};
        return;
    }
    listTransitions(ui, set, chosen, [&](const AnimationTransition& t) { return t.from == state; });
    ImGui::BeginDisabled(state == 0);
    if (ImGui::Button("Begin here")) {
        edit.beginWith(state);
        if (edit.set() != set) chosen.index = 0;
    }
    ui.widgets.mark("Animation/begin");
    ImGui::EndDisabled();
    tooltip(state == 0 ? "This is already the initial state" : "Makes this the initial state");
}

void MachineDetails::drawTransition(Ui& ui, StateMachineEdit& edit, MachinePart& chosen) {
    const int index = chosen.index;
    const std::string title = transitionText(edit.set(), at(edit.set().transitions, index));
    drawTitle(ui, edit, chosen, title);
    if (chosen.kind != Kind::Transition) return;
    for (int i = 0; i < static_cast<int>(at(edit.set().transitions, index).when.size()); ++i)
        drawCondition(ui, edit, index, i);
    drawAddCondition(ui, edit, index);
    bool afterEnd = at(edit.set().transitions, index).afterEnd;
    if (ImGui::Checkbox("when the clip has ended", &afterEnd)) edit.setAfterEnd(index, afterEnd);
    ui.widgets.mark("Animation/afterEnd", at(edit.set().transitions, index).afterEnd ? "on" : "off");
    tooltip("Waits for the end of the clip; for a looping clip, for the end of the current loop");
    const AnimationTransition& now = at(edit.set().transitions, index);
    if (now.when.empty() && !now.afterEnd) {
        ImGui::PushStyleColor(ImGuiCol_Text, palette::kWarning);
        ImGui::TextWrapped("Without a condition the transition is taken at once.");
        ImGui::PopStyleColor();
        ui.widgets.mark("Animation/atOnce");
    }
    drawOrder(ui, edit, chosen);
}

void MachineDetails::drawCondition(Ui& ui, StateMachineEdit& edit, int transition, int condition) {
    const AnimationSet set = edit.set();
    const AnimationCondition now = at(at(set.transitions, transition).when, condition);
    const std::string path = format("Animation/when/{}", condition);
    const float gap = ui.px(4.0f);
    const float room = ImGui::GetContentRegionAvail().x - ui.px(kRemoveWidth) - gap;
    const float question = ui.px(kSignWidth + kValueWidth) + gap;
    ImGui::PushID(condition);
    ImGui::SetNextItemWidth(std::max(room - question - gap, ui.px(40.0f)));
    const auto nameOf = [&](int i) { return at(set.parameters, i).name; };
    if (const auto other =
            chooseName(ui, path + "/parameter", now.parameter, static_cast<int>(set.parameters.size()),
                       nameOf(now.parameter).c_str(), nameOf)) {
        AnimationCondition next = now;
        next.parameter = *other;
        edit.setCondition(transition, condition, next);
    }
    tooltip(nameOf(now.parameter));
    ImGui::SameLine(0.0f, gap);
    drawQuestion(ui, edit, transition, condition, question);
    ImGui::SameLine(0.0f, gap);
    if (ImGui::Button("x", {ui.px(kRemoveWidth), 0.0f})) edit.removeCondition(transition, condition);
    ui.widgets.mark(path + "/remove");
    tooltip("Removes this condition");
    ImGui::PopID();
}

void MachineDetails::drawQuestion(Ui& ui, StateMachineEdit& edit, int transition, int condition,
                                  float width) {
    const AnimationSet& set = edit.set();
    const std::vector<AnimationCondition>& when = at(set.transitions, transition).when;
    if (condition >= static_cast<int>(when.size())) return;
    AnimationCondition next = at(when, condition);
    const std::string path = format("Animation/when/{}", condition);
    const bool trigger = at(set.parameters, next.parameter).kind == ParameterKind::Trigger;
    const Asks asks = conditionKind(set, next);
    if (asks != Asks::Number) {
        const auto nameOf = [&](int i) {
            return std::string{trigger ? (i == 0 ? "is set" : "is not set") : i == 0 ? "is on" : "is off"};
        };
        const int shown = asks == Asks::On ? 0 : 1;
        ImGui::SetNextItemWidth(width);
        const auto other = chooseName(ui, path + "/is", shown, 2, nameOf(shown).c_str(), nameOf);
        if (!other) return;
        next.is = Comparison::Equal;
        next.value = *other == 0 ? 1.0f : 0.0f;
        return edit.setCondition(transition, condition, next);
    }
    ImGui::SetNextItemWidth(ui.px(kSignWidth));
    const auto signName = [](int i) { return std::string{signOf(static_cast<Comparison>(i))}; };
    if (const auto is = chooseName(ui, path + "/is", static_cast<int>(next.is), kComparisons, signOf(next.is),
                                   signName)) {
        next.is = static_cast<Comparison>(*is);
        return edit.setCondition(transition, condition, next);
    }
    ImGui::SameLine(0.0f, ui.px(4.0f));
    ImGui::SetNextItemWidth(ui.px(kValueWidth));
    if (const auto value = number_.draw(ui, path + "/value", next.value, 0.5f, "%.4g")) {
        next.value = *value;
        edit.setCondition(transition, condition, next);
    }
    tooltip("Drag, or Ctrl+click to type a number");
}

void MachineDetails::drawParameter(Ui& ui, StateMachineEdit& edit, MachinePart& chosen) {
    const AnimationSet set = edit.set();
    const int index = chosen.index;
    const AnimationParameter& now = at(set.parameters, index);
    drawTitle(ui, edit, chosen, "Parameter " + now.name);
    drawLabel(ui, "Name");
    if (const auto name = text_.draw(ui, "Animation/parameterName", now.name))
        edit.renameParameter(index, *name);
    tooltip("Name by which the game sets the parameter");
    drawLabel(ui, "Kind");
    const auto kindName = [](int i) { return std::string{kKinds[static_cast<std::size_t>(i)]}; };
    const int kind = static_cast<int>(now.kind);
    if (const auto other = chooseName(ui, "Animation/parameterKind", kind, static_cast<int>(kKinds.size()),
                                      kindName(kind).c_str(), kindName))
        edit.setParameter(index, static_cast<ParameterKind>(*other), now.initial);
    tooltip("A trigger stays on until a transition that tests it is taken");
    if (now.kind == ParameterKind::Float) {
        drawLabel(ui, "Starts");
        if (const auto initial = number_.draw(ui, "Animation/initial", now.initial, 0.5f, "%.4g"))
            edit.setParameter(index, now.kind, *initial);
        tooltip("Initial value, until the game sets it");
    } else if (now.kind == ParameterKind::Bool) {
        drawLabel(ui, "Starts");
        bool on = now.initial != 0.0f;
        if (ImGui::Checkbox("on##initial", &on)) edit.setParameter(index, now.kind, on ? 1.0f : 0.0f);
        ui.widgets.mark("Animation/initial", now.initial != 0.0f ? "on" : "off");
        tooltip("Initial value, until the game sets it");
    }
    const int asked = conditionsOn(set, index);
    const GameParameter* known = findGameParameter(now.name);
    const std::string text = format("{} it. {}",
                                    asked == 0   ? std::string{"No condition tests"}
                                    : asked == 1 ? std::string{"1 condition tests"}
                                                 : format("{} conditions test", asked),
                                    known == nullptr ? std::string{"The game's code sets it by name."}
                                                     : format("The engine sets it. {}.", known->doc));
    ImGui::PushStyleColor(ImGuiCol_Text, palette::kTextDim);
    ImGui::TextWrapped("%s", text.c_str());
    ImGui::PopStyleColor();
    ui.widgets.mark("Animation/asked", text);
}

void removePart(StateMachineEdit& edit, MachinePart& chosen) {
    const MachinePart part = chosen;
    const AnimationSet before = edit.set();
    switch (part.kind) {
        case Kind::State: edit.removeState(part.index); break;
        case Kind::Transition: edit.removeTransition(part.index); break;
        case Kind::Parameter: edit.removeParameter(part.index); break;
        case Kind::None: break;
    }
    if (edit.set() != before) chosen = {};
}

}  // namespace plumb::editor::ui
