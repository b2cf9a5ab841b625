#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace plumb::physics {

/// A part of the simulation that a scene can do without. Each runs only where something calls for it.
enum class Effect : std::uint8_t {
    Gravity,        ///< a dynamic body that gravity pulls
    Rotation,       ///< a dynamic body that may turn
    Friction,       ///< a shape with friction
    Restitution,    ///< a shape that bounces
    Rolling,        ///< a shape with rolling resistance
    Drag,           ///< a body with drag
    Joints,         ///< a joint
    Motors,         ///< a joint with a motor
    Continuous,     ///< a dynamic body, while Settings::continuous
    Sleep,          ///< a body that can sleep, while Settings::sleeping
    Contacts,       ///< a dynamic body with a shape that is no trigger
    Triggers,       ///< a trigger
    ContactEvents,  ///< a shape that reports contacts
    OneWay,         ///< a one-way shape
    Conveyor,       ///< a shape with a surface speed
    Kinematics,     ///< a kinematic body
    Locks,          ///< a body locked along an axis
    AreaGravity,    ///< fields, by kind
    Wind,
    Buoyancy,
    Attractor,
    Explosion,
    Springs,     ///< smooth springs, integrated with the bodies
    SoftBodies,  ///< position based bodies and cloth
    Count
};

inline constexpr std::size_t kEffects = static_cast<std::size_t>(Effect::Count);

/// What a scene calls for: a count of callers for each effect, kept as they come and go.
struct Manifest {
    std::array<std::uint32_t, kEffects> callers{};
    std::uint32_t pinnedOn = 0;   ///< bits of effects that run though nobody calls for them
    std::uint32_t pinnedOff = 0;  ///< bits of effects that do not run whoever calls for them

    [[nodiscard]] static constexpr std::uint32_t bit(Effect effect) {
        return 1u << static_cast<std::uint32_t>(effect);
    }
    [[nodiscard]] bool runs(Effect effect) const {
        const bool called = callers[static_cast<std::size_t>(effect)] > 0 || (pinnedOn & bit(effect)) != 0;
        return called && (pinnedOff & bit(effect)) == 0;
    }
    /// The bits of all effects that run.
    [[nodiscard]] std::uint32_t running() const {
        std::uint32_t called = pinnedOn;
        for (std::size_t i = 0; i < kEffects; ++i) called |= callers[i] > 0 ? 1u << i : 0u;
        return called & ~pinnedOff;
    }
    /// One caller more or less.
    void call(Effect effect, bool on, int times = 1) {
        if (on) callers[static_cast<std::size_t>(effect)] += static_cast<std::uint32_t>(times);
    }
    void leave(Effect effect, bool on) { call(effect, on, -1); }
};

std::string_view nameOf(Effect effect);

}  // namespace plumb::physics
