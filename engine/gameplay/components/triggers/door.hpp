#pragma once

#include "reflect/type_builder.hpp"

namespace plumb {

/// A wall that opens with keys, or while its button is pressed.
struct Door {
    int keys = 1;       ///< number of keys that opening it uses up; 0: cannot be opened with keys
    EntityId button;    ///< entity of the Button that opens it; if set, keys do not open it
    bool open = false;  ///< the door is open: its collider is a trigger

    static void describe(TypeBuilder<Door>& type) {
        type.name("Door").doc("A wall that opens with keys, or while its button is pressed.");
        type.field<&Door::keys>("keys")
            .range(0.0f, 100.0f)
            .doc("Number of keys that opening the door uses up; 0: cannot be opened with keys.");
        type.field<&Door::button>("button").doc(
            "Entity of the Button that opens the door; if set, keys do not open it.");
        type.field<&Door::open>("open").transient();
    }
};

}  // namespace plumb
