#pragma once

#include "editor/model/assets/state_machine_edit.hpp"
#include "editor/ui/widgets/held_value.hpp"
#include "editor/ui/widgets/state_graph.hpp"

namespace plumb::editor::ui {

/// What is chosen of a state machine, and all that can be changed of it: a state, a transition with its
/// conditions, or a parameter. With nothing chosen all transitions are listed.
class MachineDetails {
public:
    /// @param chosen  what another click here chooses
    void draw(Ui& ui, StateMachineEdit& edit, MachinePart& chosen);

private:
    void drawState(Ui& ui, StateMachineEdit& edit, MachinePart& chosen);
    void drawTransition(Ui& ui, StateMachineEdit& edit, MachinePart& chosen);
    void drawParameter(Ui& ui, StateMachineEdit& edit, MachinePart& chosen);
    void drawCondition(Ui& ui, StateMachineEdit& edit, int transition, int condition);
    /// Comparison and value, or whether it is on.
    void drawQuestion(Ui& ui, StateMachineEdit& edit, int transition, int condition, float width);

    HeldNumber number_;
    HeldText text_;
};

/// Takes out what is chosen; the next one of the same kind is not chosen instead.
void removePart(StateMachineEdit& edit, MachinePart& chosen);

}  // namespace plumb::editor::ui
