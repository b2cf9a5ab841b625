#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "input/input_frame.hpp"

namespace plumb {

enum class BindingKind : std::uint8_t { Key, MouseButton, PadButton, PadAxis, PadAxisPlus, PadAxisMinus };

/// One key, button or stick that an action or an axis listens to. As text: "Space", "Mouse Left", "Pad A",
/// "Pad LeftX", one half of a stick "Pad LeftX-", and of one gamepad only "Pad2 A".
struct Binding {
    static constexpr std::int8_t kAnyPad = -1;

    BindingKind kind = BindingKind::Key;
    std::uint8_t code = 0;      ///< Key, MouseButton, PadButton or PadAxis
    std::int8_t pad = kAnyPad;  ///< place 0..3

    friend bool operator==(const Binding&, const Binding&) = default;
};

std::string toText(Binding binding);
std::optional<Binding> bindingFromText(std::string_view text);

/// The name closest to a mistyped one, for "did you mean"; empty when none is near.
std::string closestBinding(std::string_view text);

/// How far it is pressed or pushed: 0..1 for keys, buttons and halves of sticks, -1..1 for whole sticks.
/// @param deadZone  ratio of a stick's reach, 0..1, that counts as rest; what lies beyond is stretched to
/// 0..1.
///                  It is round: a stick that is pushed far to one side keeps its small other part
float strengthOf(Binding binding, const InputFrame& frame, float deadZone);

/// True when it is pressed, or a stick or trigger pushed more than half.
bool isHeld(Binding binding, const InputFrame& frame, float deadZone);

}  // namespace plumb
