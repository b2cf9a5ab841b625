#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.hpp"
#include "input/action.hpp"
#include "input/binding.hpp"
#include "reflect/json_fwd.hpp"

namespace plumb {

/// An action and all that triggers it.
struct ActionBindings {
    std::string name;
    std::vector<Binding> bindings;

    friend bool operator==(const ActionBindings&, const ActionBindings&) = default;
};

/// An axis: keys and buttons to both sides, and sticks.
struct AxisBindings {
    std::string name;
    std::vector<Binding> negative;
    std::vector<Binding> positive;
    std::vector<Binding> analog;

    friend bool operator==(const AxisBindings&, const AxisBindings&) = default;
};

/// Which keys, buttons and sticks mean what: the "input" part of project.json, and the player's own choice.
struct ActionMap {
    static constexpr std::size_t kMaxActions = 64;
    static constexpr std::size_t kMaxAxes = 32;
    static constexpr std::size_t kMaxBindings = 16;  ///< of one action or one side

    std::vector<ActionBindings> actions;
    std::vector<AxisBindings> axes;
    float deadZone = 0.2f;  ///< ratio of a stick's reach that counts as rest

    /// What a game has that says nothing: arrows, WASD, space and the first gamepad found.
    static ActionMap defaults();

    /// Index of an action or an axis; -1 when there is none.
    [[nodiscard]] int find(Action action) const;
    [[nodiscard]] int find(Axis axis) const;

    /// Binds an action anew, as a settings screen does. Adds it when it is new.
    void bind(std::string_view action, std::vector<Binding> bindings);

    friend bool operator==(const ActionMap&, const ActionMap&) = default;
};

/// Reads {"actions": {"Jump": ["Space", "Pad A"]}, "axes": {"Horizontal": {"negative": …, "positive": …,
/// "analog": …}}} on top of the defaults: what it does not name keeps its keys. What is wrong is reported and
/// left out.
/// @param where  the place of the object, e.g. "project.json: input"
ActionMap actionMapFromJson(const Json& json, std::string_view where, std::vector<Error>& problems);

/// The whole map as JSON; reading it gives the same map.
Json toJson(const ActionMap& map);

}  // namespace plumb
