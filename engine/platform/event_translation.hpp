#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "platform/events.hpp"

union SDL_Event;

namespace plumb {

/// Translates SDL's events and keeps the gamepads open. SDL
/// numbers gamepads by connection, the engine by slots 0..3.
class EventTranslation {
public:
    ~EventTranslation();

    /// @return the event; nothing for events that the engine does not use
    std::optional<Event> translate(const SDL_Event& event);

private:
    struct Pad {
        void* controller = nullptr;
        std::int32_t instance = -1;
    };

    [[nodiscard]] std::optional<int> slotOf(std::int32_t instance) const;
    std::optional<Event> addPad(int device);
    std::optional<Event> removePad(std::int32_t instance);
    [[nodiscard]] std::optional<Event> padButtonEvent(bool down, std::int32_t instance, int button) const;
    [[nodiscard]] std::optional<Event> padAxisEvent(std::int32_t instance, int axis, float value) const;

    std::array<Pad, kPadCount> pads_{};
};

}  // namespace plumb
