#pragma once

#include "editor/model/assets/state_machine_edit.hpp"
#include "editor/ui/widgets/held_value.hpp"
#include "editor/ui/widgets/state_graph.hpp"

namespace plumb::editor::ui {

/// Edits the selected part of an animation state machine: a state, a transition with its conditions, or a
/// parameter. Lists all transitions if nothing is selected.
class MachineDetails {
public:
    /// @param chosen  the selected part; a click in the details may select another one
    void draw(Ui& ui, StateMachineEdit& edit, MachinePart& chosen);

private:
    void drawState(Ui& ui, StateMachineEdit& edit, MachinePart& chosen);
    void drawTransition(Ui& ui, StateMachineEdit& edit, MachinePart& chosen);
    void drawParameter(Ui& ui, StateMachineEdit& edit, MachinePart& chosen);
    void drawCondition(Ui& ui, StateMachineEdit& edit, int transition, int condition);
    /// Draws what a condition tests: comparison and value of a number, or the on/off choice of other kinds.
    void drawQuestion(Ui& ui, StateMachineEdit& edit, int transition, int condition, float width);

    DeferredNumber number_;
    DeferredText text_;
};

/// Removes the selected part of the state machine; nothing is selected afterwards.
void removePart(StateMachineEdit& edit, MachinePart& chosen);

}  // namespace plumb::editor::ui
