#pragma once

#include <optional>
#include <utility>

#include "assets/animation.hpp"
#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// A part of a state machine: what is chosen in its graph and shown beside it.
struct MachinePart {
    enum class Kind : unsigned char { None, State, Transition, Parameter };
    Kind kind = Kind::None;
    int index = 0;

    friend bool operator==(const MachinePart&, const MachinePart&) = default;
};

/// What was done to the graph in this frame.
struct GraphHands {
    std::optional<MachinePart> chosen;          ///< a click; none beside everything
    std::optional<std::pair<int, int>> joined;  ///< dragged from one state (-1: any) to another
    int entered = -1;                           ///< the state of a double click
};

/// The states of an animation as a ring of boxes, "any" in their middle, and transitions as arrows between
/// them.
/// @param chosen   is marked, and what goes on from it
/// @param playing  the state that plays now; -1: none
GraphHands drawStateGraph(Ui& ui, const AnimationSet& set, MachinePart chosen, int playing, ImVec2 room);

}  // namespace plumb::editor::ui
