#include "editor/model/assets/state_machine_edit.hpp"

#include <algorithm>
#include <array>

#include "assets/clip_cursor.hpp"
#include "core/text.hpp"

namespace plumb::editor {
namespace {

constexpr float kMaxSpeed = 1000.0f;  // maximum that the file format allows
constexpr float kMaxValue = 1e9f;

constexpr std::array kSigns{">", "<", ">=", "<=", "==", "!="};

using Kind = ParameterKind;
constexpr auto kGameParameters = std::to_array<GameParameter>({
    {"speed", Kind::Float, "Horizontal speed, px/s"},
    {"vy", Kind::Float, "Vertical velocity, px/s; negative is up"},
    {"grounded", Kind::Bool, "True while standing on the ground"},
    {"dead", Kind::Bool, "True if health is 0"},
    {"hurt", Kind::Bool, "True shortly after damage, while invulnerable"},
    {"pressed", Kind::Bool, "Button: something presses it. Spring: it launches something"},
    {"open", Kind::Bool, "Door: it is open"},
    {"active", Kind::Bool, "Checkpoint or goal: it was reached"},
    {"stomped", Kind::Bool, "Enemy: a player jumped on it"},
});

template <class T>
bool isIndex(const std::vector<T>& items, int index) {
    return index >= 0 && index < static_cast<int>(items.size());
}
template <class T>
T& at(std::vector<T>& items, int index) {
    return items[static_cast<std::size_t>(index)];
}
template <class T>
const T& at(const std::vector<T>& items, int index) {
    return items[static_cast<std::size_t>(index)];
}

/// Adjusts an index into a list from which an item was erased.
int withoutIndex(int index, int removed) { return index > removed ? index - 1 : index; }

std::string freeName(const AnimationSet& set, std::string_view wanted,
                     int (AnimationSet::*find)(std::string_view) const) {
    std::string name{wanted};
    for (int number = 2; (set.*find)(name) >= 0; ++number) name = format("{} {}", wanted, number);
    return name;
}

/// Returns the default name of a new parameter.
std::string_view firstName(ParameterKind kind) {
    switch (kind) {
        case Kind::Float: return "number";
        case Kind::Bool: return "isOn";
        case Kind::Trigger: break;
    }
    return "trigger";
}

void eraseParameter(AnimationSet& set, int parameter) {
    set.parameters.erase(set.parameters.begin() + parameter);
    for (AnimationTransition& transition : set.transitions) {
        const std::size_t removed = std::erase_if(
            transition.when, [&](const AnimationCondition& c) { return c.parameter == parameter; });
        if (removed > 0 && transition.when.empty()) transition.afterEnd = true;
        for (AnimationCondition& condition : transition.when)
            condition.parameter = withoutIndex(condition.parameter, parameter);
    }
}

}  // namespace

void StateMachineEdit::addState(int clip) {
    file_.change("add a state", [&](AnimationSet& set) {
        if (!isIndex(set.clips, clip)) return;
        set.states.push_back({freeName(set, at(set.clips, clip).name, &AnimationSet::findState), clip, 1.0f});
    });
}

void StateMachineEdit::removeState(int state) {
    file_.change("remove a state", [&](AnimationSet& set) {
        if (isIndex(set.states, state)) eraseState(set, state);
    });
}

void StateMachineEdit::renameState(int state, std::string_view name) {
    file_.change("rename a state", [&](AnimationSet& set) {
        if (isIndex(set.states, state) && !name.empty() && set.findState(name) < 0)
            at(set.states, state).name = name;
    });
}

void StateMachineEdit::setClip(int state, int clip) {
    file_.change("set the clip of a state", [&](AnimationSet& set) {
        if (isIndex(set.states, state) && isIndex(set.clips, clip)) at(set.states, state).clip = clip;
    });
}

void StateMachineEdit::setSpeed(int state, float speed) {
    file_.change("change the speed of a state", [&](AnimationSet& set) {
        if (isIndex(set.states, state))
            at(set.states, state).speed = std::clamp(speed, -kMaxSpeed, kMaxSpeed);
    });
}

void StateMachineEdit::beginWith(int state) {
    file_.change("change the initial state", [&](AnimationSet& set) {
        if (!isIndex(set.states, state)) return;
        std::rotate(set.states.begin(), set.states.begin() + state, set.states.begin() + state + 1);
        const auto moved = [&](int index) { return index == state ? 0 : index < state ? index + 1 : index; };
        for (AnimationTransition& transition : set.transitions) {
            if (transition.from != AnimationTransition::kAnyState) transition.from = moved(transition.from);
            transition.to = moved(transition.to);
        }
    });
}

void StateMachineEdit::addTransition(int from, int to) {
    file_.change("add a transition", [&](AnimationSet& set) {
        if (!isIndex(set.states, to) ||
            (from != AnimationTransition::kAnyState && !isIndex(set.states, from)))
            return;
        AnimationTransition transition;
        transition.from = from;
        transition.to = to;
        transition.afterEnd = true;  // without a condition it would be taken at once
        set.transitions.push_back(std::move(transition));
    });
}

void StateMachineEdit::removeTransition(int transition) {
    file_.change("remove a transition", [&](AnimationSet& set) {
        if (isIndex(set.transitions, transition)) set.transitions.erase(set.transitions.begin() + transition);
    });
}

int StateMachineEdit::moveTransition(int transition, int by) {
    const int to = transition + by;
    const bool moved = file_.change("reorder transitions", [&](AnimationSet& set) {
        if (isIndex(set.transitions, transition) && isIndex(set.transitions, to))
            std::swap(at(set.transitions, transition), at(set.transitions, to));
    });
    return moved ? to : transition;
}

void StateMachineEdit::setAfterEnd(int transition, bool afterEnd) {
    file_.change(afterEnd ? "wait for the end of the clip" : "do not wait for the end of the clip",
                 [&](AnimationSet& set) {
                     if (isIndex(set.transitions, transition))
                         at(set.transitions, transition).afterEnd = afterEnd;
                 });
}

void StateMachineEdit::addCondition(int transition, int parameter) {
    file_.change("add a condition", [&](AnimationSet& set) {
        if (!isIndex(set.transitions, transition) || !isIndex(set.parameters, parameter)) return;
        std::vector<AnimationCondition>& when = at(set.transitions, transition).when;
        if (when.size() < kMaxConditions) when.push_back(usualCondition(set, parameter));
    });
}

void StateMachineEdit::setCondition(int transition, int condition, AnimationCondition to) {
    file_.change("change a condition", [&](AnimationSet& set) {
        if (!isIndex(set.transitions, transition) || !isIndex(set.parameters, to.parameter)) return;
        std::vector<AnimationCondition>& when = at(set.transitions, transition).when;
        if (!isIndex(when, condition)) return;
        AnimationCondition& now = at(when, condition);
        const bool otherKind =
            at(set.parameters, now.parameter).kind != at(set.parameters, to.parameter).kind;
        now = otherKind ? usualCondition(set, to.parameter) : to;
        now.value = std::clamp(now.value, -kMaxValue, kMaxValue);
    });
}

void StateMachineEdit::removeCondition(int transition, int condition) {
    file_.change("remove a condition", [&](AnimationSet& set) {
        if (!isIndex(set.transitions, transition)) return;
        std::vector<AnimationCondition>& when = at(set.transitions, transition).when;
        if (isIndex(when, condition)) when.erase(when.begin() + condition);
    });
}

void StateMachineEdit::addParameter(ParameterKind kind, std::string_view name) {
    file_.change("add a parameter", [&](AnimationSet& set) {
        if (set.parameters.size() >= AnimationSet::kMaxParameters) return;
        const std::string_view wanted = name.empty() ? firstName(kind) : name;
        set.parameters.push_back({freeName(set, wanted, &AnimationSet::findParameter), kind, 0.0f});
    });
}

void StateMachineEdit::renameParameter(int parameter, std::string_view name) {
    file_.change("rename a parameter", [&](AnimationSet& set) {
        if (isIndex(set.parameters, parameter) && !name.empty() && set.findParameter(name) < 0)
            at(set.parameters, parameter).name = name;
    });
}

void StateMachineEdit::setParameter(int parameter, ParameterKind kind, float initial) {
    file_.change("change a parameter", [&](AnimationSet& set) {
        if (!isIndex(set.parameters, parameter)) return;
        AnimationParameter& now = at(set.parameters, parameter);
        now.kind = kind;
        now.initial = kind == Kind::Float     ? std::clamp(initial, -kMaxValue, kMaxValue)
                      : kind == Kind::Trigger ? 0.0f
                      : initial != 0.0f       ? 1.0f
                                              : 0.0f;
    });
}

void StateMachineEdit::removeParameter(int parameter) {
    if (!isIndex(set().parameters, parameter)) return;
    const std::string name = at(set().parameters, parameter).name;
    const int asked = conditionsOn(set(), parameter);
    const bool removed =
        file_.change("remove a parameter", [&](AnimationSet& set) { eraseParameter(set, parameter); });
    if (removed && asked > 0)
        file_.workspace().notice =
            format("Removed {} and {} on it", name,
                   asked == 1 ? std::string{"1 condition"} : format("{} conditions", asked));
}

void eraseState(AnimationSet& set, int state) {
    set.states.erase(set.states.begin() + state);
    std::erase_if(set.transitions,
                  [&](const AnimationTransition& t) { return t.from == state || t.to == state; });
    for (AnimationTransition& transition : set.transitions) {
        transition.from = withoutIndex(transition.from, state);
        transition.to = withoutIndex(transition.to, state);
    }
}

int conditionsOn(const AnimationSet& set, int parameter) {
    std::ptrdiff_t count = 0;
    for (const AnimationTransition& transition : set.transitions)
        count += std::count_if(transition.when.begin(), transition.when.end(),
                               [&](const AnimationCondition& c) { return c.parameter == parameter; });
    return static_cast<int>(count);
}

AnimationCondition usualCondition(const AnimationSet& set, int parameter) {
    if (at(set.parameters, parameter).kind == Kind::Bool) return {parameter, Comparison::Equal, 1.0f};
    return {parameter, Comparison::Greater, 0.0f};
}

Asks conditionKind(const AnimationSet& set, const AnimationCondition& condition) {
    if (at(set.parameters, condition.parameter).kind == Kind::Float) return Asks::Number;
    const bool off = holds(condition, 0.0f), on = holds(condition, 1.0f);
    return on == off ? Asks::Number : on ? Asks::On : Asks::Off;
}

std::string conditionText(const AnimationSet& set, const AnimationCondition& condition) {
    const AnimationParameter& parameter = at(set.parameters, condition.parameter);
    const char* on = parameter.kind == Kind::Trigger ? "set" : "on";
    const char* off = parameter.kind == Kind::Trigger ? "not set" : "off";
    switch (conditionKind(set, condition)) {
        case Asks::On: return format("{} is {}", parameter.name, on);
        case Asks::Off: return format("{} is {}", parameter.name, off);
        case Asks::Number: break;
    }
    return format("{} {} {}", parameter.name, signOf(condition.is), condition.value);
}

std::string conditionsText(const AnimationSet& set, const AnimationTransition& transition) {
    std::string text;
    for (const AnimationCondition& condition : transition.when)
        text += (text.empty() ? "" : ", ") + conditionText(set, condition);
    if (transition.afterEnd) text += text.empty() ? "after its end" : ", after its end";
    return text.empty() ? "at once" : text;
}

std::string transitionText(const AnimationSet& set, const AnimationTransition& transition) {
    const bool any = transition.from == AnimationTransition::kAnyState;
    return format("{} to {}", any ? std::string{"any"} : at(set.states, transition.from).name,
                  at(set.states, transition.to).name);
}

const char* signOf(Comparison comparison) { return kSigns[static_cast<std::size_t>(comparison)]; }

std::span<const GameParameter> gameParameters() { return kGameParameters; }

const GameParameter* findGameParameter(std::string_view name) {
    const auto found = std::find_if(kGameParameters.begin(), kGameParameters.end(),
                                    [&](const GameParameter& known) { return known.name == name; });
    return found == kGameParameters.end() ? nullptr : &*found;
}

}  // namespace plumb::editor
