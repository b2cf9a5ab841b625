#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "core/hash.hpp"
#include "math/vec2.hpp"
#include "platform/events.hpp"
#include "platform/key.hpp"

namespace plumb {

/// The state of one gamepad in one tick.
struct PadFrame {
    std::uint16_t buttons = 0;                       ///< one bit per PadButton
    std::array<std::int16_t, kPadAxisCount> axes{};  ///< by PadAxis, -32767..32767, without dead zone

    [[nodiscard]] bool has(PadButton button) const {
        return (buttons >> static_cast<unsigned>(button) & 1) != 0;
    }
    [[nodiscard]] float axis(PadAxis which) const {
        return static_cast<float>(axes[static_cast<std::size_t>(which)]) / 32767.0f;
    }

    friend bool operator==(const PadFrame&, const PadFrame&) = default;
};

inline constexpr int kSaveSlots = 32;  ///< of saved games, numbered from 1

/// The complete input of a tick: the held keys and buttons, not the changes. Plain data of a fixed size, so
/// it can be recorded, replayed and sent; the same frames give the same game.
struct InputFrame {
    std::array<std::uint32_t, 4> keys{};  ///< one bit per Key
    std::int16_t mouseX = 0;              ///< px in the game's own resolution, for any size of the window
    std::int16_t mouseY = 0;              ///< px in the game's own resolution
    std::int16_t wheelX = 0;              ///< motion in this tick, 1/120 notches
    std::int16_t wheelY = 0;          ///< motion in this tick, 1/120 notches; away from the user is positive
    std::uint16_t mouseButtons = 0;   ///< one bit per MouseButton
    std::uint16_t connectedPads = 0;  ///< one bit per gamepad
    std::array<PadFrame, kPadCount> pads{};
    /// One bit per slot of saved games that has one: what the simulation knows of files is input. Not hashed,
    /// as the next tick depends on its own frame only.
    std::uint32_t saves = 0;

    [[nodiscard]] bool has(Key key) const {
        const auto bit = static_cast<std::size_t>(key);
        return (keys[bit / 32] >> bit % 32 & 1) != 0;
    }
    [[nodiscard]] bool has(MouseButton button) const {
        return (mouseButtons >> static_cast<unsigned>(button) & 1) != 0;
    }
    void set(Key key, bool held) {
        const auto bit = static_cast<std::size_t>(key);
        const std::uint32_t mask = std::uint32_t{1} << bit % 32;
        keys[bit / 32] = held ? keys[bit / 32] | mask : keys[bit / 32] & ~mask;
    }
    [[nodiscard]] Vec2 mouse() const { return {static_cast<float>(mouseX), static_cast<float>(mouseY)}; }
    /// @param position  px in the game's own resolution
    void setMouse(Vec2 position) {
        const auto whole = [](float value) {
            // The comparison is false for NaN.
            return static_cast<std::int16_t>(value > -32768.0f ? std::min(std::floor(value), 32767.0f)
                                                               : -32768.0f);
        };
        mouseX = whole(position.x);
        mouseY = whole(position.y);
    }

    void addTo(Hasher& hasher) const { hasher.addBytes(this, offsetof(InputFrame, saves)); }

    friend bool operator==(const InputFrame&, const InputFrame&) = default;
};

static_assert(kKeyCount <= 128, "InputFrame needs another word of keys");
static_assert(kPadButtonCount <= 16, "PadFrame needs more bits for buttons");
static_assert(std::is_trivially_copyable_v<InputFrame>);
static_assert(std::has_unique_object_representations_v<InputFrame>, "hashed as bytes: no padding");

}  // namespace plumb
