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

/// An action and the bindings that trigger it.
struct ActionBindings {
    std::string name;
    std::vector<Binding> bindings;

    friend bool operator==(const ActionBindings&, const ActionBindings&) = default;
};

/// An axis: keys and buttons for both directions, and sticks.
struct AxisBindings {
    std::string name;
    std::vector<Binding> negative;
    std::vector<Binding> positive;
    std::vector<Binding> analog;

    friend bool operator==(const AxisBindings&, const AxisBindings&) = default;
};

/// The bindings of keys, buttons and sticks to actions and axes: the "input" object of project.json, with the
/// changes of the player.
struct ActionMap {
    static constexpr std::size_t kMaxActions = 64;
    static constexpr std::size_t kMaxAxes = 32;
    static constexpr std::size_t kMaxBindings = 16;  ///< per action, or per list of an axis

    std::vector<ActionBindings> actions;
    std::vector<AxisBindings> axes;
    float deadZone = 0.2f;  ///< ratio of a stick's range that counts as centered

    /// The bindings of a game without an "input" object: arrow keys, WASD, space and all gamepads.
    static ActionMap defaults();

    /// Index of an action or an axis; -1 if the map does not contain it.
    [[nodiscard]] int find(Action action) const;
    [[nodiscard]] int find(Axis axis) const;

    /// Replaces the bindings of an action, e.g. in a settings screen. Adds the action if it is new.
    void bind(std::string_view action, std::vector<Binding> bindings);

    friend bool operator==(const ActionMap&, const ActionMap&) = default;
};

/// Reads {"actions": {"Jump": ["Space", "Pad A"]}, "axes": {"Horizontal": {"negative": …, "positive": …,
/// "analog": …}}} on top of the defaults: actions and lists that it does not contain keep their bindings.
/// Invalid entries are reported and skipped.
/// @param where  the location of the object, for messages, e.g. "project.json: input"
ActionMap actionMapFromJson(const Json& json, std::string_view where, std::vector<Error>& problems);
/// The same on top of another map. It stays as it is but for the bindings: actions and axes that it does not
/// have are reported.
ActionMap reboundFromJson(const ActionMap& base, const Json& json, std::string_view where,
                          std::vector<Error>& problems);

/// Returns the whole map as JSON, from which actionMapFromJson() creates the same map.
Json toJson(const ActionMap& map);
/// Returns the actions and axes of which `map` has other bindings than `base`, for reboundFromJson().
Json bindingChanges(const ActionMap& base, const ActionMap& map);

}  // namespace plumb
