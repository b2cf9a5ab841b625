#pragma once

#include "reflect/type_builder.hpp"

namespace plumb {

/// Makes a Hazard an enemy that dies, instead of hurting, when a player jumps on it.
struct Stompable {
    float bounce = 260.0f;  ///< px/s, upward speed that the player gets
    float lingers = 0.3f;   ///< s from the stomp until the entity is destroyed

    static void describe(TypeBuilder<Stompable>& type) {
        type.name("Stompable")
            .doc("Makes a Hazard an enemy that dies, instead of hurting, when a player jumps on it.");
        type.field<&Stompable::bounce>("bounce")
            .unit(Unit::PixelsPerSecond)
            .range(0.0f, 10000.0f)
            .doc("Upward speed that the player gets, px/s.");
        type.field<&Stompable::lingers>("lingers")
            .unit(Unit::Seconds)
            .range(0.0f, 60.0f)
            .doc("Time from the stomp until the entity is destroyed, s.");
    }
};

}  // namespace plumb
