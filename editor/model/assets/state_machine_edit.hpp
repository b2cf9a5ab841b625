#pragma once

#include <span>
#include <string>
#include <string_view>

#include "editor/model/assets/animation_edit.hpp"

namespace plumb::editor {

/// The state machine of an animation file that is open: states, the transitions between them, what those ask
/// for, and the parameters. Every change is one step of undo and is written at once.
class StateMachineEdit {
public:
    static constexpr std::size_t kMaxConditions = 64;  ///< of one transition: more are not read

    explicit StateMachineEdit(AnimationEdit& file) : file_{file} {}

    [[nodiscard]] const AnimationSet& set() const { return file_.set(); }

    // States. The first one is the start.

    void addState(int clip);
    void removeState(int state);
    /// Nothing when the name is empty or taken.
    void renameState(int state, std::string_view name);
    void setClip(int state, int clip);
    void setSpeed(int state, float speed);
    /// Makes it the first one.
    void beginWith(int state);

    // Transitions. Of several that may be taken the first one is.

    /// It waits for the end of the clip, until something else is asked for.
    /// @param from  AnimationTransition::kAnyState: from wherever it is
    void addTransition(int from, int to);
    void removeTransition(int transition);
    /// @return where it is then
    int moveTransition(int transition, int by);
    void setAfterEnd(int transition, bool afterEnd);

    // Conditions: all of a transition must hold.

    /// That the parameter is on, or above 0.
    void addCondition(int transition, int parameter);
    /// Where it asks for a parameter of another kind than before, comparison and value begin anew.
    void setCondition(int transition, int condition, AnimationCondition to);
    void removeCondition(int transition, int condition);

    // Parameters.

    /// @param name  empty: one that is free
    void addParameter(ParameterKind kind, std::string_view name = {});
    /// Nothing when the name is empty or taken.
    void renameParameter(int parameter, std::string_view name);
    void setParameter(int parameter, ParameterKind kind, float initial);
    /// Conditions that ask for it go too. A transition of which none is left waits for the end of its clip,
    /// because else it would be taken at once.
    void removeParameter(int parameter);

private:
    AnimationEdit& file_;
};

/// Takes a state out, with the transitions from it and to it.
void takeStateOut(AnimationSet& set, int state);

/// How many conditions ask for a parameter.
int conditionsOn(const AnimationSet& set, int parameter);

/// What a new condition on a parameter asks for.
AnimationCondition usualCondition(const AnimationSet& set, int parameter);

/// What a condition says of an on-off parameter or a trigger.
enum class Asks : unsigned char { Number, On, Off };
/// Number: of a parameter that is one, or a comparison that is no question of on and off.
Asks asksFor(const AnimationSet& set, const AnimationCondition& condition);

/// "speed > 12", "grounded is on".
std::string conditionText(const AnimationSet& set, const AnimationCondition& condition);
/// "speed > 12, after its end"; "at once" without any condition.
std::string whenText(const AnimationSet& set, const AnimationTransition& transition);
/// "idle to run", "any to run".
std::string wayText(const AnimationSet& set, const AnimationTransition& transition);

/// ">", "<" and so on, in the order of Comparison.
const char* signOf(Comparison comparison);

/// A parameter that systems of the engine set by its name, where a state machine has it.
struct GameParameter {
    std::string_view name;
    ParameterKind kind;
    std::string_view doc;
};
std::span<const GameParameter> gameParameters();
/// Null when no system of the engine sets it.
const GameParameter* findGameParameter(std::string_view name);

}  // namespace plumb::editor
