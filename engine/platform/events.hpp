#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "math/vec2.hpp"
#include "platform/key.hpp"

namespace plumb {

/// Events of a window and its devices. Plain data:
/// recorded, created by tests, read by input and editor.
enum class EventKind : std::uint8_t {
    Quit,
    FocusGained,
    FocusLost,
    Resized,
    KeyDown,
    KeyUp,
    TextInput,
    MouseMoved,
    MouseDown,
    MouseUp,
    MouseWheel,
    PadAdded,
    PadRemoved,
    PadDown,
    PadUp,
    PadAxisMoved,
    FileDropped,
};

/// Modifier keys that were held when a key or a mouse button changed.
struct Modifiers {
    bool shift = false;
    bool control = false;  ///< also the command key on macOS
    bool alt = false;

    friend bool operator==(Modifiers, Modifiers) = default;
};

/// An event. Only the members that belong to its kind are meaningful.
struct Event {
    EventKind kind = EventKind::Quit;
    Key key = Key::None;                          ///< KeyDown, KeyUp
    bool repeated = false;                        ///< KeyDown sent again because the key is still held
    Modifiers modifiers;                          ///< KeyDown, KeyUp, MouseDown, MouseUp, MouseWheel
    MouseButton mouseButton = MouseButton::Left;  ///< MouseDown, MouseUp
    std::uint8_t clicks = 1;                      ///< MouseDown: 2 for a double click
    Vec2 position;                                ///< px in the window: Mouse*; Resized: the new size
    Vec2 motion;                         ///< MouseMoved: px since the last event; MouseWheel: notches
    int pad = 0;                         ///< Pad*: index of the gamepad, 0..3
    PadButton padButton = PadButton::A;  ///< PadDown, PadUp
    PadAxis padAxis = PadAxis::LeftX;    ///< PadAxisMoved
    float value = 0.0f;                  ///< PadAxisMoved: -1..1, triggers 0..1
    std::string text;                    ///< TextInput (UTF-8), FileDropped (path)
};

inline constexpr int kPadCount = 4;

}  // namespace plumb
