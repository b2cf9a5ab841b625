#pragma once

#include "reflect/type_builder.hpp"

namespace plumb {

/// A trigger that completes the level when a player touches it.
struct Goal {
    SceneId next;           ///< the scene that follows the level; empty: the scene does not change
    float delay = 0.6f;     ///< s, from the touch to the next scene
    bool endsGame = false;  ///< touching this goal finishes the game
    int leaving = 0;        ///< ticks until the next scene; 0 before the touch, 1 after the request

    static void describe(TypeBuilder<Goal>& type) {
        type.name("Goal").doc("A trigger that completes the level when a player touches it.");
        type.field<&Goal::next>("next").doc("Scene that follows the level.");
        type.field<&Goal::delay>("delay")
            .unit(Unit::Seconds)
            .range(0.0f, 30.0f)
            .doc("Time from the touch to the next scene, s.");
        type.field<&Goal::endsGame>("endsGame").doc("Touching this goal finishes the game.");
        type.field<&Goal::leaving>("leaving").unit(Unit::Ticks).transient();
    }
};

}  // namespace plumb
