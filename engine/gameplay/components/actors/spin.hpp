#pragma once

#include "reflect/type_builder.hpp"

namespace plumb {

/// Turns the entity at a steady rate.
struct Spin {
    float rate = 1.0f;  ///< rad/s, clockwise on screen

    static void describe(TypeBuilder<Spin>& type) {
        type.name("Spin").doc("Turns the entity at a steady rate.");
        type.field<&Spin::rate>("rate")
            .unit(Unit::RadiansPerSecond)
            .range(-100.0f, 100.0f)
            .doc("Clockwise on screen.");
    }
};

}  // namespace plumb
