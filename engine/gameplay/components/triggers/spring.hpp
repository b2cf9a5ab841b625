#pragma once

#include "math/vec2.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// A trigger that launches every RigidBody that touches it.
struct Spring {
    Vec2 speed = {0.0f, -420.0f};  ///< px/s, velocity that the body gets; where 0, it keeps its own
    bool onlyFromAbove = true;     ///< ignore bodies that move upwards
    int pressed = 0;               ///< ticks until it is shown as released, counted down from a launch

    static void describe(TypeBuilder<Spring>& type) {
        type.name("Spring").doc("A trigger that launches every RigidBody that touches it.");
        type.field<&Spring::speed>("speed")
            .unit(Unit::PixelsPerSecond)
            .doc("Velocity that the body gets, px/s; where x or y is 0, the body keeps its own.");
        type.field<&Spring::onlyFromAbove>("onlyFromAbove").doc("Ignores bodies that move upwards.");
        type.field<&Spring::pressed>("pressed").unit(Unit::Ticks).transient();
    }
};

}  // namespace plumb
