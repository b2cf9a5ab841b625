#pragma once

#include <cstdint>

#include "math/vec2.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

enum class Easing : std::uint8_t { Linear, Smooth };

/// Moves the entity back and forth along a straight path and
/// carries the bodies on it. Needs a KinematicBody and a collider.
struct MovingPlatform {
    Vec2 way = {64.0f, 0.0f};        ///< px, from the initial position to the other end of the path
    float period = 4.0f;             ///< s, travel time there and back, without waiting
    float phase = 0.0f;              ///< initial phase, as a ratio of the period
    Easing easing = Easing::Smooth;  ///< motion near the ends: sudden, or with gradual acceleration
    float wait = 0.0f;               ///< s, waiting time at each end
    Vec2 home;                       ///< px, initial position
    bool started = false;            ///< `home` has been set
    std::uint32_t ticks = 0;         ///< ticks since the platform started

    static void describe(TypeBuilder<MovingPlatform>& type) {
        type.name("MovingPlatform")
            .doc(
                "Moves the entity back and forth along a straight path and carries the bodies on it. Needs a "
                "KinematicBody and a collider.");
        type.field<&MovingPlatform::way>("way")
            .unit(Unit::Pixels)
            .doc("Displacement from the initial position to the other end, px.");
        type.field<&MovingPlatform::period>("period")
            .unit(Unit::Seconds)
            .range(0.05f, 600.0f)
            .doc("Travel time there and back, s, without waiting.");
        type.field<&MovingPlatform::phase>("phase")
            .unit(Unit::Ratio)
            .range(0.0f, 1.0f)
            .doc("Initial phase, as a ratio of the period.");
        type.field<&MovingPlatform::easing>("easing")
            .names({{"linear", 0}, {"smooth", 1}})
            .doc("Motion near the ends: linear, or smooth with gradual acceleration.");
        type.field<&MovingPlatform::wait>("wait")
            .unit(Unit::Seconds)
            .range(0.0f, 60.0f)
            .doc("Waiting time at each end, s.");
        type.field<&MovingPlatform::home>("home").unit(Unit::Pixels).transient();
        type.field<&MovingPlatform::started>("started").transient();
        type.field<&MovingPlatform::ticks>("ticks").unit(Unit::Ticks).transient();
    }
};

}  // namespace plumb
