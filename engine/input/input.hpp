#pragma once

#include <array>
#include <cstdint>

#include "input/action.hpp"
#include "input/action_map.hpp"
#include "input/input_frame.hpp"

namespace plumb {

/// What the player does in this tick, in the game's own words.
class Input {
public:
    explicit Input(ActionMap map = ActionMap::defaults());

    /// Goes down, is down, goes up in this tick. An action that the map does not know never does.
    [[nodiscard]] bool isPressed(Action action) const;
    [[nodiscard]] bool isHeld(Action action) const;
    [[nodiscard]] bool isReleased(Action action) const;

    /// How far it is pushed, -1..1; keys count fully and win over sticks.
    [[nodiscard]] float getAxis(Axis axis) const;

    /// Keys and buttons as such, for tools and for text games.
    [[nodiscard]] bool isPressed(Key key) const { return frame_.has(key) && !previous_.has(key); }
    [[nodiscard]] bool isHeld(Key key) const { return frame_.has(key); }
    [[nodiscard]] bool isPressed(MouseButton button) const {
        return frame_.has(button) && !previous_.has(button);
    }
    [[nodiscard]] bool isHeld(MouseButton button) const { return frame_.has(button); }
    [[nodiscard]] Vec2 mouse() const { return frame_.mouse(); }  ///< px of the picture

    /// Begins the next tick with what the devices, a replay or the network say.
    void advance(const InputFrame& next);

    /// Puts both frames in place, e.g. after a snapshot was restored.
    void restore(const InputFrame& previous, const InputFrame& current);

    [[nodiscard]] const InputFrame& frame() const { return frame_; }
    [[nodiscard]] const InputFrame& previousFrame() const { return previous_; }

    /// What the next tick depends on: which actions were down.
    void addTo(Hasher& hasher) const { previous_.addTo(hasher), frame_.addTo(hasher); }

    [[nodiscard]] const ActionMap& map() const { return map_; }
    void setMap(ActionMap map);

    /// Writes "[Input] Jump pressed" to the log. Off at first: a log line allocates.
    bool logging = false;

private:
    struct State {
        std::uint64_t held = 0;  // bits by action
        std::array<float, ActionMap::kMaxAxes> axes{};
    };

    [[nodiscard]] State evaluate(const InputFrame& frame) const;

    ActionMap map_;
    std::vector<std::uint64_t> actionIds_;  // by action of the map
    std::vector<std::uint64_t> axisIds_;
    InputFrame previous_;
    InputFrame frame_;
    State before_;
    State now_;
};

}  // namespace plumb
