#pragma once

#include <array>
#include <cstdint>
#include <utility>

#include "core/state_archive.hpp"
#include "input/action.hpp"
#include "input/action_map.hpp"
#include "input/input_frame.hpp"

namespace plumb {

/// The input of the current tick, as actions and axes of the game.
class Input {
public:
    explicit Input(ActionMap map = ActionMap::defaults());

    /// True in the tick in which the action begins; false for actions that are not in the map, as isHeld()
    /// and isReleased() are.
    [[nodiscard]] bool isPressed(Action action) const;
    /// True from the tick in which the action begins, as long as a key or button of it is held.
    [[nodiscard]] bool isHeld(Action action) const;
    /// True in the first tick in which the action is not held any more.
    [[nodiscard]] bool isReleased(Action action) const;

    /// Returns the value of an axis, -1..1. A key or button gives -1 or 1 and overrides sticks.
    [[nodiscard]] float getAxis(Axis axis) const;

    /// The same for a key or a button of the mouse itself, without bindings.
    [[nodiscard]] bool isPressed(Key key) const { return frame_.has(key) && !previous_.has(key); }
    [[nodiscard]] bool isHeld(Key key) const { return frame_.has(key); }
    [[nodiscard]] bool isReleased(Key key) const { return !frame_.has(key) && previous_.has(key); }
    [[nodiscard]] bool isPressed(MouseButton button) const {
        return frame_.has(button) && !previous_.has(button);
    }
    [[nodiscard]] bool isHeld(MouseButton button) const { return frame_.has(button); }
    [[nodiscard]] bool isReleased(MouseButton button) const {
        return !frame_.has(button) && previous_.has(button);
    }
    [[nodiscard]] Vec2 mouse() const { return frame_.mouse(); }  ///< px in the game's own resolution

    /// Begins the next tick with the input of the devices, a replay or the network.
    void advance(const InputFrame& next);

    /// Replaces both frames, e.g. after a snapshot was restored.
    void restore(const InputFrame& previous, const InputFrame& current);

    [[nodiscard]] const InputFrame& frame() const { return frame_; }
    [[nodiscard]] const InputFrame& previousFrame() const { return previous_; }

    /// The input is part of a saved game, the bindings are not: they are those of the player.
    void archive(StateArchive& archive);

    /// Hashes the input state on which the next tick depends.
    void addTo(Hasher& hasher) const { previous_.addTo(hasher), frame_.addTo(hasher); }

    /// Actions and axes that the game has asked for, by their index in the map.
    struct Asked {
        std::uint64_t actions = 0;
        std::uint64_t axes = 0;

        friend bool operator==(const Asked&, const Asked&) = default;
    };
    /// Returns what was asked for since the last call: the buttons that a touch screen needs. No part of the
    /// simulation.
    Asked takeAsked() { return std::exchange(asked_, Asked{}); }

    [[nodiscard]] const ActionMap& map() const { return map_; }
    void setMap(ActionMap map);

    /// Logs pressed actions as "[Input] Jump pressed". A game that runs in a window begins with true;
    /// onCreate() can set false. False otherwise, because a log line allocates memory.
    bool logging = false;

private:
    struct State {
        std::uint64_t held = 0;  // one bit per action
        std::array<float, ActionMap::kMaxAxes> axes{};
    };

    [[nodiscard]] State evaluate(const InputFrame& frame) const;
    [[nodiscard]] bool isIn(std::uint64_t actions, Action action) const;

    ActionMap map_;
    std::vector<std::uint64_t> actionIds_;  // one per action of the map
    std::vector<std::uint64_t> axisIds_;
    InputFrame previous_;
    InputFrame frame_;
    State before_;  // state of previous_
    State now_;     // state of frame_
    mutable Asked asked_;
};

}  // namespace plumb
