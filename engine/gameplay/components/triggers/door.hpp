#pragma once

#include "reflect/type_builder.hpp"

namespace plumb {

/// A wall that opens for a key, or while its button is pressed.
struct Door {
    int keys = 1;       ///< keys it takes; 0 for a door with a button
    EntityId button;    ///< the Button that opens it
    bool open = false;  ///< lets all through

    static void describe(TypeBuilder<Door>& type) {
        type.name("Door").doc("A wall that opens for a key, or while its button is pressed.");
        type.field<&Door::keys>("keys").range(0.0f, 100.0f).doc("Keys it takes; 0 for a door with a button.");
        type.field<&Door::button>("button").doc("The Button that opens it.");
        type.field<&Door::open>("open").transient();
    }
};

}  // namespace plumb
