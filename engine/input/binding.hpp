#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "input/input_frame.hpp"

namespace plumb {

enum class BindingKind : std::uint8_t { Key, MouseButton, PadButton, PadAxis, PadAxisPlus, PadAxisMinus };

/// A key, button or stick that triggers an action or moves an axis. As text: "Space", "Mouse Left", "Pad A",
/// "Pad LeftX", one half of a stick "Pad LeftX-", and on the second gamepad only "Pad2 A".
struct Binding {
    static constexpr std::int8_t kAnyPad = -1;

    BindingKind kind = BindingKind::Key;
    std::uint8_t code = 0;      ///< Key, MouseButton, PadButton or PadAxis
    std::int8_t pad = kAnyPad;  ///< index of the gamepad, 0..3, or kAnyPad

    friend bool operator==(const Binding&, const Binding&) = default;
};

std::string toText(Binding binding);
std::optional<Binding> bindingFromText(std::string_view text);

/// The binding closest to a mistyped one, for "did you mean"; empty if none is similar.
std::string closestBinding(std::string_view text);

/// Returns how far a binding is pressed: 0..1 for keys, buttons and halves of sticks, -1..1 for whole sticks.
/// @param deadZone  ratio of a stick's range, 0..1, that counts as centered; the rest is stretched to 0..1.
///                  It is a circle: a stick pushed far along one axis keeps a small value of the other axis
float strengthOf(Binding binding, const InputFrame& frame, float deadZone);

/// True if a key or button is pressed, or a stick or trigger is pushed more than halfway.
bool isHeld(Binding binding, const InputFrame& frame, float deadZone);

}  // namespace plumb
