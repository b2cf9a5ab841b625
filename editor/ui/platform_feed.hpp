#pragma once

#include <array>
#include <deque>
#include <span>
#include <vector>

#include "math/vec2.hpp"
#include "platform/events.hpp"
#include "platform/window.hpp"

namespace plumb::editor::ui {

/// What happened to the window since the last frame, and how large it is.
struct FrameInput {
    std::span<const Event> events;
    PixelSize size{1280, 720};      ///< in the units of mouse positions
    PixelSize drawable{1280, 720};  ///< in pixels
    float seconds = 1.0f / 60.0f;   ///< since the last frame
};

/// Feeds ImGui from plain events; nothing is asked of SDL, so a test plays with the same hands as a person.
/// Each frame takes events up to the second change of one key or button: a press and its release never share
/// a frame, because ImGui would see neither.
class PlatformFeed {
public:
    /// @pre an ImGui context is current
    PlatformFeed();

    /// Takes what fits into this frame; the rest waits for the next one.
    /// @return the events of this frame, in order
    std::span<const Event> beginFrame(const FrameInput& input);

    /// Events of a frame that does not come to be: they wait for the next one.
    void keep(std::span<const Event> events) {
        waiting_.insert(waiting_.end(), events.begin(), events.end());
    }

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
