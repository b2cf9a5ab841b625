#pragma once

#include <span>
#include <string>
#include <string_view>

#include "editor/model/assets/animation_edit.hpp"

namespace plumb::editor {

/// Editor of an open animation file's state machine: states, transitions with conditions, and parameters.
/// Every change is one undo step and is written to the file at once.
class StateMachineEdit {
public:
    static constexpr std::size_t kMaxConditions = 64;  ///< maximum per transition; loading ignores more

    explicit StateMachineEdit(AnimationEdit& file) : file_{file} {}

    [[nodiscard]] const AnimationSet& set() const { return file_.set(); }

    // States. The first one is the initial state.

    void addState(int clip);
    void removeState(int state);
    /// Does nothing if the name is empty or taken.
    void renameState(int state, std::string_view name);
    void setClip(int state, int clip);
    void setSpeed(int state, float speed);
    /// Makes a state the initial state.
    void beginWith(int state);

    // Transitions. If several of them can be taken, the first one in the list is taken.

    /// Adds a transition that is taken at the end of the clip, without other conditions.
    /// @param from  state, or AnimationTransition::kAnyState
    void addTransition(int from, int to);
    void removeTransition(int transition);
    /// @param by  number of positions, negative: towards the front. @return the transition's new index
    int moveTransition(int transition, int by);
    void setAfterEnd(int transition, bool afterEnd);

    // Conditions. A transition is taken if all of them hold.

    /// Adds the condition that the parameter is on or, for a number, above 0.
    void addCondition(int transition, int parameter);
    /// Changes a condition. If its new parameter is of another kind, comparison and value are reset.
    void setCondition(int transition, int condition, AnimationCondition to);
    void removeCondition(int transition, int condition);

    // Parameters.

    /// @param name  empty: an unused default name
    void addParameter(ParameterKind kind, std::string_view name = {});
    /// Does nothing if the name is empty or taken.
    void renameParameter(int parameter, std::string_view name);
    void setParameter(int parameter, ParameterKind kind, float initial);
    /// Removes a parameter and the conditions on it. A transition left without conditions then waits for the
    /// end of its clip, because otherwise it would be taken at once.
    void removeParameter(int parameter);

private:
    AnimationEdit& file_;
};

/// Removes a state and all transitions from and to it.
void eraseState(AnimationSet& set, int state);

/// Returns the number of conditions on a parameter.
int conditionsOn(const AnimationSet& set, int parameter);

/// Returns the default condition on a parameter: on, or for a number above 0.
AnimationCondition usualCondition(const AnimationSet& set, int parameter);

/// Kind of a condition: on a number, or that a bool or trigger is on or off.
enum class Asks : unsigned char { Number, On, Off };
/// Returns Number for number parameters, and for comparisons that do not distinguish on from off.
Asks conditionKind(const AnimationSet& set, const AnimationCondition& condition);

/// Returns the text of a condition: "speed > 12", "grounded is on".
std::string conditionText(const AnimationSet& set, const AnimationCondition& condition);
/// Returns the conditions of a transition: "speed > 12, after its end"; "at once" if it has none.
std::string conditionsText(const AnimationSet& set, const AnimationTransition& transition);
/// Returns the states of a transition: "idle to run", "any to run".
std::string transitionText(const AnimationSet& set, const AnimationTransition& transition);

/// Returns the operator of a comparison: ">", "<", …
const char* signOf(Comparison comparison);

/// A parameter that the engine's systems set if a state machine has one of this name.
struct GameParameter {
    std::string_view name;
    ParameterKind kind;
    std::string_view doc;
};
std::span<const GameParameter> gameParameters();
/// Returns null if no system of the engine sets a parameter of this name.
const GameParameter* findGameParameter(std::string_view name);

}  // namespace plumb::editor
