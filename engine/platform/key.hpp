#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace plumb {

// Keys and buttons, with the engine's own numbers: new entries are added only at the
// end, before Count. Names in files and in the editor are those of the enumerators,
// but digit keys have only the digit.

/// A key by its position on a US keyboard, so that WASD has the same position on every layout.
enum class Key : std::uint8_t {
    // clang-format off
    None,
    A, B, C, D, E, F, G, H, I, J, K, L, M, N, O, P, Q, R, S, T, U, V, W, X, Y, Z,
    Digit0, Digit1, Digit2, Digit3, Digit4, Digit5, Digit6, Digit7, Digit8, Digit9,
    Enter, Escape, Backspace, Tab, Space,
    Minus, Equals, LeftBracket, RightBracket, Backslash, Semicolon, Apostrophe, Grave, Comma, Period, Slash,
    CapsLock, F1, F2, F3, F4, F5, F6, F7, F8, F9, F10, F11, F12,
    PrintScreen, ScrollLock, Pause, Insert, Home, PageUp, Delete, End, PageDown,
    Right, Left, Down, Up,
    NumLock, PadDivide, PadMultiply, PadMinus, PadPlus, PadEnter, PadPeriod,
    Pad0, Pad1, Pad2, Pad3, Pad4, Pad5, Pad6, Pad7, Pad8, Pad9,
    LeftControl, LeftShift, LeftAlt, LeftSuper, RightControl, RightShift, RightAlt, RightSuper, Menu,
    Count
    // clang-format on
};
inline constexpr std::size_t kKeyCount = static_cast<std::size_t>(Key::Count);

enum class MouseButton : std::uint8_t { Left, Middle, Right, X1, X2, Count };
inline constexpr std::size_t kMouseButtonCount = static_cast<std::size_t>(MouseButton::Count);

/// Buttons by their position on an Xbox pad: A is the lower one. In SDL's order.
enum class PadButton : std::uint8_t {
    // clang-format off
    A, B, X, Y, Back, Guide, Start, LeftStick, RightStick, LeftShoulder, RightShoulder, Up, Down, Left, Right, Count
    // clang-format on
};
inline constexpr std::size_t kPadButtonCount = static_cast<std::size_t>(PadButton::Count);

/// Axes: sticks from -1 to 1, right and down are positive; triggers from 0 to 1. In SDL's order.
enum class PadAxis : std::uint8_t { LeftX, LeftY, RightX, RightY, LeftTrigger, RightTrigger, Count };
inline constexpr std::size_t kPadAxisCount = static_cast<std::size_t>(PadAxis::Count);

/// The name in bindings ("W", "Left", "5", "F11", "LeftShift"), empty for None, and the inverse function.
std::string_view nameOf(Key key);
std::string_view nameOf(MouseButton button);
std::string_view nameOf(PadButton button);
std::string_view nameOf(PadAxis axis);
std::optional<Key> keyFromName(std::string_view name);
std::optional<MouseButton> mouseButtonFromName(std::string_view name);
std::optional<PadButton> padButtonFromName(std::string_view name);
std::optional<PadAxis> padAxisFromName(std::string_view name);

}  // namespace plumb
