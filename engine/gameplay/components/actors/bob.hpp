#pragma once

#include "math/vec2.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// Moves the entity's Sprite up and down periodically; colliders do not move.
struct Bob {
    Vec2 amplitude = {0.0f, 2.0f};  ///< px, amplitude of the oscillation
    float period = 1.5f;            ///< s, period of the oscillation
    float phase = 0.0f;             ///< initial phase, as a ratio of the period
    float time = 0.0f;              ///< s since the period began; kept per entity, so that a pause stops it
    Vec2 shown;                     ///< px, current offset of the sprite

    static void describe(TypeBuilder<Bob>& type) {
        type.name("Bob").doc("Moves the entity's Sprite up and down periodically; colliders do not move.");
        type.field<&Bob::amplitude>("amplitude").unit(Unit::Pixels).doc("Amplitude of the oscillation, px.");
        type.field<&Bob::period>("period")
            .unit(Unit::Seconds)
            .range(0.05f, 60.0f)
            .doc("Period of the oscillation, s.");
        type.field<&Bob::phase>("phase")
            .unit(Unit::Ratio)
            .range(0.0f, 1.0f)
            .doc("Initial phase, as a ratio of the period.");
        type.field<&Bob::time>("time").unit(Unit::Seconds).transient();
        type.field<&Bob::shown>("shown").unit(Unit::Pixels).transient();
    }
};

}  // namespace plumb
