#pragma once

#include "math/vec2.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// Comes back after death, at the last checkpoint or where it began.
struct Respawn {
    float delay = 0.7f;   ///< s, between death and return
    Vec2 place;           ///< px, where it comes back
    bool placed = false;  ///< place is known
    int waiting = 0;      ///< ticks, until it comes back, 0 while alive

    static void describe(TypeBuilder<Respawn>& type) {
        type.name("Respawn").doc("Comes back after death, at the last checkpoint or where it began.");
        type.field<&Respawn::delay>("delay")
            .unit(Unit::Seconds)
            .range(0.0f, 30.0f)
            .doc("Between death and return.");
        type.field<&Respawn::place>("place").unit(Unit::Pixels).transient();
        type.field<&Respawn::placed>("placed").transient();
        type.field<&Respawn::waiting>("waiting").unit(Unit::Ticks).transient();
    }
};

}  // namespace plumb
