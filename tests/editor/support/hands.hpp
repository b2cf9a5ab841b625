#pragma once

#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "editor/ui/editor_window.hpp"

namespace plumb::editor::ui {

/// Simulates mouse and keyboard input: sends events to an editor window and runs frames. The window handles
/// the events like those of the operating system.
class Hands {
public:
    explicit Hands(EditorWindow& window) : window_{window} { rest(3); }

    PixelSize size = FrameInput{}.size;  ///< size of the window
    Modifiers held;                      ///< modifier keys held during mouse clicks and drags

    void rest(int frames = 1) {
        for (int i = 0; i < frames; ++i) {
            send({});
        }
    }
    void moveTo(Vec2 at) { send({{.kind = EventKind::MouseMoved, .position = at}}), place_ = at; }
    void press(MouseButton button = MouseButton::Left) { sendMouse(EventKind::MouseDown, button); }
    void release(MouseButton button = MouseButton::Left) { sendMouse(EventKind::MouseUp, button); }

    /// Returns the center of a widget. Fails the test if no widget has this path.
    [[nodiscard]] Vec2 middleOf(std::string_view widget) const {
        const WidgetMap::Widget* found = window_.widgets().find(widget);
        EXPECT_NE(found, nullptr) << widget << " is not on the screen";
        return found == nullptr ? Vec2{} : found->box.center();
    }
    void click(std::string_view widget) { clickAt(middleOf(widget)); }
    void clickAt(Vec2 at, MouseButton button = MouseButton::Left) {
        moveTo(at), rest(), press(button), release(button), rest();
    }

    void drag(Vec2 from, Vec2 to, int steps = 10) {
        moveTo(from), rest(), press();
        for (int i = 1; i <= steps; ++i) {
            moveTo(lerp(from, to, static_cast<float>(i) / static_cast<float>(steps)));
        }
        release(), rest();
    }

    void key(Key key, Modifiers modifiers = {}) {
        send({{.kind = EventKind::KeyDown, .key = key, .modifiers = modifiers}});
        send({{.kind = EventKind::KeyUp, .key = key, .modifiers = {}}});
        rest();
    }
    void type(std::string_view text) {
        for (const char letter : text) {
            send({{.kind = EventKind::TextInput, .text = std::string(1, letter)}});
        }
    }
    /// Replaces the value of a number field: Ctrl+click turns the field into a text input.
    void enterNumber(std::string_view widget, std::string_view text) {
        moveTo(middleOf(widget)), rest();
        send({{.kind = EventKind::KeyDown, .key = Key::LeftControl, .modifiers = {.control = true}}});
        send({{.kind = EventKind::MouseDown, .modifiers = {.control = true}, .position = place_}});
        send({{.kind = EventKind::MouseUp, .modifiers = {.control = true}, .position = place_}});
        send({{.kind = EventKind::KeyUp, .key = Key::LeftControl}});
        rest(2);
        type(text);
        key(Key::Enter);
    }

private:
    void sendMouse(EventKind kind, MouseButton button) {
        send({{.kind = kind, .modifiers = held, .mouseButton = button, .position = place_}});
    }
    void send(std::vector<Event> events) { window_.frame({events, size, size}); }

    EditorWindow& window_;
    Vec2 place_;
};

}  // namespace plumb::editor::ui
