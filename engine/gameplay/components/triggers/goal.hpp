#pragma once

#include "reflect/type_builder.hpp"

namespace plumb {

/// A trigger that ends the level.
struct Goal {
    SceneId next;           ///< the scene that follows
    float delay = 0.6f;     ///< s, from the touch to the next scene
    bool endsGame = false;  ///< nothing but titles follows
    int leaving = 0;        ///< ticks, until the next scene, 0 before the player arrives

    static void describe(TypeBuilder<Goal>& type) {
        type.name("Goal").doc("A trigger that ends the level.");
        type.field<&Goal::next>("next").doc("The scene that follows.");
        type.field<&Goal::delay>("delay")
            .unit(Unit::Seconds)
            .range(0.0f, 30.0f)
            .doc("From the touch to the next scene.");
        type.field<&Goal::endsGame>("endsGame").doc("Nothing but titles follows.");
        type.field<&Goal::leaving>("leaving").unit(Unit::Ticks).transient();
    }
};

}  // namespace plumb
