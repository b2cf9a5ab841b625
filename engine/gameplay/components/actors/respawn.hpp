#pragma once

#include "math/vec2.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// Makes the entity respawn after death, at the last checkpoint or at its initial position.
struct Respawn {
    float delay = 0.7f;   ///< s, from death to respawn
    Vec2 place;           ///< px, respawn position
    bool placed = false;  ///< `place` has been set
    int waiting = 0;      ///< ticks until it respawns; 0 while alive

    static void describe(TypeBuilder<Respawn>& type) {
        type.name("Respawn").doc(
            "Makes the entity respawn after death, at the last checkpoint or at its initial position.");
        type.field<&Respawn::delay>("delay")
            .unit(Unit::Seconds)
            .range(0.0f, 30.0f)
            .doc("Time from death to respawn, s.");
        type.field<&Respawn::place>("place").unit(Unit::Pixels).transient();
        type.field<&Respawn::placed>("placed").transient();
        type.field<&Respawn::waiting>("waiting").unit(Unit::Ticks).transient();
    }
};

}  // namespace plumb
