#pragma once

#include <optional>
#include <utility>

#include "assets/animation.hpp"
#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// A selectable part of a state machine.
struct MachinePart {
    enum class Kind : unsigned char { None, State, Transition, Parameter };
    Kind kind = Kind::None;
    int index = 0;  ///< index among the parts of this kind

    friend bool operator==(const MachinePart&, const MachinePart&) = default;
};

/// User actions on the graph in this frame.
struct GraphInput {
    std::optional<MachinePart> chosen;          ///< the clicked part; Kind::None: a click on the background
    std::optional<std::pair<int, int>> joined;  ///< new transition by drag: from a state (-1: any) to another
    int entered = -1;                           ///< double-clicked state; -1: none
};

/// Draws an animation state machine: states as a ring of boxes around "any", transitions as arrows.
/// @param chosen   the selected part; it is highlighted, and of a state also its outgoing transitions
/// @param playing  the current state; -1: none
GraphInput drawStateGraph(Ui& ui, const AnimationSet& set, MachinePart chosen, int playing, ImVec2 room);

}  // namespace plumb::editor::ui
