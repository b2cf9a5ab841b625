#pragma once

#include "math/vec2.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// A trigger at which a player that touched it respawns.
struct Checkpoint {
    Vec2 offset;          ///< px, from the Transform to the respawn position
    bool active = false;  ///< this is the checkpoint that was touched last

    static void describe(TypeBuilder<Checkpoint>& type) {
        type.name("Checkpoint").doc("A trigger at which a player that touched it respawns.");
        type.field<&Checkpoint::offset>("offset")
            .unit(Unit::Pixels)
            .doc("Vector from the Transform to the respawn position, px.");
        type.field<&Checkpoint::active>("active").transient();
    }
};

}  // namespace plumb
