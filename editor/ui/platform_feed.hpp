#pragma once

#include <array>
#include <deque>
#include <span>
#include <vector>

#include "math/vec2.hpp"
#include "platform/events.hpp"
#include "platform/window.hpp"

namespace plumb::editor::ui {

/// The events since the last frame, and the size of the window.
struct FrameInput {
    std::span<const Event> events;
    PixelSize size{1280, 720};      ///< size of the window in the units of mouse positions
    PixelSize drawable{1280, 720};  ///< size of the framebuffer, px; larger than `size` on high-DPI screens
    float seconds = 1.0f / 60.0f;   ///< s since the last frame
};

/// Passes plain events to ImGui, without SDL, so that tests can simulate a user's input. ImGui would miss a
/// press and a release in the same frame, so a frame takes only the events before the second change of one
/// key or button; the others wait for the next frame.
class PlatformFeed {
public:
    /// @pre an ImGui context is current
    PlatformFeed();

    /// Passes the events that fit into this frame to ImGui; the others wait for the next frame.
    /// @return the events of this frame, in order
    std::span<const Event> beginFrame(const FrameInput& input);

    /// Keeps the events of a skipped frame for the next one.
    void keep(std::span<const Event> events) {
        waiting_.insert(waiting_.end(), events.begin(), events.end());
    }

    /// True if events wait for the next frame.
    [[nodiscard]] bool pending() const { return !waiting_.empty(); }
    [[nodiscard]] Modifiers modifiers() const { return modifiers_; }
    [[nodiscard]] Vec2 mouse() const { return mouse_; }
    [[nodiscard]] bool held(Key key) const { return keys_[static_cast<std::size_t>(key)]; }
    [[nodiscard]] bool held(MouseButton button) const { return buttons_[static_cast<std::size_t>(button)]; }

private:
    void feed(const Event& event);
    void feedKey(Key key, bool down);
    void feedButton(MouseButton button, bool down);
    void feedModifiers();
    void releaseAll();

    std::deque<Event> waiting_;
    std::vector<Event> now_;
    Modifiers modifiers_;
    Vec2 mouse_{-1e6f, -1e6f};
    std::array<bool, kKeyCount> keys_{};
    std::array<bool, kMouseButtonCount> buttons_{};
};

}  // namespace plumb::editor::ui
