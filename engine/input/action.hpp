#pragma once

#include <string_view>

#include "core/text_store.hpp"

namespace plumb {

/// An input action, independent of the keys bound to it; its id is the hash of its name. Games define further
/// actions in project.json and refer to them in code by `Action{"Dash"}`.
struct Action {
    TextId id;

    constexpr explicit Action(std::string_view name) : id{textId(name)} {}
    friend constexpr bool operator==(Action a, Action b) { return a.id.value == b.id.value; }

    static const Action Jump, Attack, Interact, Confirm, Cancel, Pause;
};

inline constexpr Action Action::Jump{"Jump"};
inline constexpr Action Action::Attack{"Attack"};
inline constexpr Action Action::Interact{"Interact"};
inline constexpr Action Action::Confirm{"Confirm"};
inline constexpr Action Action::Cancel{"Cancel"};
inline constexpr Action Action::Pause{"Pause"};

/// An input axis with values from -1 to 1; right and down are positive. Its id is the hash of its name.
struct Axis {
    TextId id;

    constexpr explicit Axis(std::string_view name) : id{textId(name)} {}
    friend constexpr bool operator==(Axis a, Axis b) { return a.id.value == b.id.value; }

    static const Axis Horizontal, Vertical;
};

inline constexpr Axis Axis::Horizontal{"Horizontal"};
inline constexpr Axis Axis::Vertical{"Vertical"};

}  // namespace plumb
