#pragma once

#include "reflect/type_builder.hpp"

namespace plumb {

/// An enemy that dies, instead of hurting, when a player jumps on it.
struct Stompable {
    float bounce = 260.0f;  ///< px/s, upwards, for the player
    float lingers = 0.3f;   ///< s, shown flattened before it is gone

    static void describe(TypeBuilder<Stompable>& type) {
        type.name("Stompable").doc("An enemy that dies, instead of hurting, when a player jumps on it.");
        type.field<&Stompable::bounce>("bounce")
            .unit(Unit::PixelsPerSecond)
            .range(0.0f, 10000.0f)
            .doc("Upwards, for the player.");
        type.field<&Stompable::lingers>("lingers")
            .unit(Unit::Seconds)
            .range(0.0f, 60.0f)
            .doc("Shown flattened before it is gone.");
    }
};

}  // namespace plumb
