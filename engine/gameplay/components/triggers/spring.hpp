#pragma once

#include "math/vec2.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// A trigger that throws up what touches it.
struct Spring {
    Vec2 speed = {0.0f, -420.0f};  ///< px/s, what it gives; a zero part keeps the own speed
    bool onlyFromAbove = true;     ///< lets pass what comes from below
    int pressed = 0;               ///< ticks, since it threw something, counted down

    static void describe(TypeBuilder<Spring>& type) {
        type.name("Spring").doc("A trigger that throws up what touches it.");
        type.field<&Spring::speed>("speed")
            .unit(Unit::PixelsPerSecond)
            .doc("What it gives; a zero part keeps the own speed.");
        type.field<&Spring::onlyFromAbove>("onlyFromAbove").doc("Lets pass what comes from below.");
        type.field<&Spring::pressed>("pressed").unit(Unit::Ticks).transient();
    }
};

}  // namespace plumb
