#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace plumb::physics {

/// An optional part of the simulation. It runs only while some object uses it; the comments name these users.
enum class Effect : std::uint8_t {
    Gravity,        ///< a dynamic body with a gravity scale other than 0
    Rotation,       ///< a dynamic body that can rotate
    Friction,       ///< a shape with friction above 0
    Restitution,    ///< a shape with bounciness above 0
    Rolling,        ///< a shape with rolling resistance
    Drag,           ///< a body with drag
    Joints,         ///< a joint
    Motors,         ///< a joint with a motor
    Continuous,     ///< a dynamic body, while Settings::continuous is true
    Sleep,          ///< a body that can sleep, while Settings::sleeping is true
    Contacts,       ///< a shape of a dynamic body that is not a trigger
    Triggers,       ///< a trigger
    ContactEvents,  ///< a shape that reports contacts
    OneWay,         ///< a one-way shape
    Conveyor,       ///< a shape with a surface speed
    Kinematics,     ///< a kinematic body
    Locks,          ///< a body locked along an axis
    AreaGravity,    ///< a field of this kind; so also the next four
    Wind,
    Buoyancy,
    Attractor,
    Explosion,
    Springs,     ///< a field of kind Spring
    SoftBodies,  ///< a soft body: rope, cloth or jelly
    Count
};

inline constexpr std::size_t kEffects = static_cast<std::size_t>(Effect::Count);

/// The effects that a scene needs: number of users of each effect.
struct Manifest {
    std::array<std::uint32_t, kEffects> requesters{};
    std::uint32_t pinnedOn = 0;   ///< bits of effects that run even without users
    std::uint32_t pinnedOff = 0;  ///< bits of effects that never run

    [[nodiscard]] static constexpr std::uint32_t bit(Effect effect) {
        return 1u << static_cast<std::uint32_t>(effect);
    }
    [[nodiscard]] bool runs(Effect effect) const {
        const bool called = requesters[static_cast<std::size_t>(effect)] > 0 || (pinnedOn & bit(effect)) != 0;
        return called && (pinnedOff & bit(effect)) == 0;
    }
    /// The bits of all effects that run.
    [[nodiscard]] std::uint32_t running() const {
        std::uint32_t called = pinnedOn;
        for (std::size_t i = 0; i < kEffects; ++i) called |= requesters[i] > 0 ? 1u << i : 0u;
        return called & ~pinnedOff;
    }
    /// Adds `times` users of an effect if `on` is true; a negative number removes users.
    void call(Effect effect, bool on, int times = 1) {
        if (on) requesters[static_cast<std::size_t>(effect)] += static_cast<std::uint32_t>(times);
    }
};

constexpr std::string_view nameOf(Effect effect) {
    constexpr std::array<std::string_view, kEffects> kNames{
        "gravity",        "rotation", "friction",  "restitution", "rolling",  "drag",
        "joints",         "motors",   "ccd",       "sleep",       "contacts", "triggers",
        "contact_events", "one_way",  "conveyor",  "kinematics",  "locks",    "area_gravity",
        "wind",           "buoyancy", "attractor", "explosion",   "springs",  "soft_bodies"};
    return kNames[static_cast<std::size_t>(effect)];
}

}  // namespace plumb::physics
