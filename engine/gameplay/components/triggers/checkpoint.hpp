#pragma once

#include "math/vec2.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// A trigger at which a player that touched it comes back to life.
struct Checkpoint {
    Vec2 offset;          ///< px, from its Transform to where the player appears
    bool active = false;  ///< the one that counts now

    static void describe(TypeBuilder<Checkpoint>& type) {
        type.name("Checkpoint").doc("A trigger at which a player that touched it comes back to life.");
        type.field<&Checkpoint::offset>("offset")
            .unit(Unit::Pixels)
            .doc("From its Transform to where the player appears.");
        type.field<&Checkpoint::active>("active").transient();
    }
};

}  // namespace plumb
