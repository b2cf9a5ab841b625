#pragma once

#include "reflect/type_builder.hpp"

namespace plumb {

/// A trigger that completes the level when a player touches it.
struct Goal {
    SceneId next;           ///< the next scene
    float delay = 0.6f;     ///< s, from the touch to the next scene
    bool endsGame = false;  ///< this is the last level
    int leaving = 0;        ///< ticks until the next scene; 0 before the touch, 1 after the request

    static void describe(TypeBuilder<Goal>& type) {
        type.name("Goal").doc("A trigger that completes the level when a player touches it.");
        type.field<&Goal::next>("next").doc("Scene that follows the level.");
        type.field<&Goal::delay>("delay")
            .unit(Unit::Seconds)
            .range(0.0f, 30.0f)
            .doc("Time from the touch to the next scene, s.");
        type.field<&Goal::endsGame>("endsGame").doc("This is the last level of the game.");
        type.field<&Goal::leaving>("leaving").unit(Unit::Ticks).transient();
    }
};

}  // namespace plumb
