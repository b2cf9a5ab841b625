#pragma once

#include <cstdint>

#include "math/vec2.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

enum class Easing : std::uint8_t { Linear, Smooth };

/// Goes to and fro along a way and carries what stands on it. Needs a KinematicBody and a collider.
struct MovingPlatform {
    Vec2 way = {64.0f, 0.0f};        ///< px, from where it stands in the scene to the other end
    float period = 4.0f;             ///< s, there and back
    float phase = 0.0f;              ///< ratio, where in its period it begins
    Easing easing = Easing::Smooth;  ///< how it nears its ends
    float wait = 0.0f;               ///< s, rest at both ends
    Vec2 home;                       ///< px, where it stands in the scene
    bool started = false;            ///< knows its home
    std::uint32_t ticks = 0;         ///< ticks, since it started

    static void describe(TypeBuilder<MovingPlatform>& type) {
        type.name("MovingPlatform")
            .doc(
                "Goes to and fro along a way and carries what stands on it. Needs a KinematicBody and a "
                "collider.");
        type.field<&MovingPlatform::way>("way")
            .unit(Unit::Pixels)
            .doc("From where it stands in the scene to the other end.");
        type.field<&MovingPlatform::period>("period")
            .unit(Unit::Seconds)
            .range(0.05f, 600.0f)
            .doc("There and back.");
        type.field<&MovingPlatform::phase>("phase")
            .unit(Unit::Ratio)
            .range(0.0f, 1.0f)
            .doc("Where in its period it begins.");
        type.field<&MovingPlatform::easing>("easing")
            .names({{"linear", 0}, {"smooth", 1}})
            .doc("How it nears its ends.");
        type.field<&MovingPlatform::wait>("wait")
            .unit(Unit::Seconds)
            .range(0.0f, 60.0f)
            .doc("Rest at both ends.");
        type.field<&MovingPlatform::home>("home").unit(Unit::Pixels).transient();
        type.field<&MovingPlatform::started>("started").transient();
        type.field<&MovingPlatform::ticks>("ticks").unit(Unit::Ticks).transient();
    }
};

}  // namespace plumb
