#pragma once

#include <string>

#include "platform/events.hpp"

namespace plumb::editor {

/// A key with the modifier keys held down with it. `Key::None` means no shortcut.
struct Shortcut {
    Key key = Key::None;
    bool control = false;
    bool shift = false;
    bool alt = false;

    [[nodiscard]] bool matches(const Event& event) const {
        return key != Key::None && event.kind == EventKind::KeyDown && event.key == key &&
               event.modifiers == Modifiers{shift, control, alt};
    }
    friend bool operator==(const Shortcut&, const Shortcut&) = default;
    /// "Ctrl+Shift+Z", for menus and tooltips.
    [[nodiscard]] std::string text() const {
        if (key == Key::None) return {};
        return std::string{control ? "Ctrl+" : ""} + (shift ? "Shift+" : "") + (alt ? "Alt+" : "") +
               std::string{nameOf(key)};
    }
};

}  // namespace plumb::editor
