#pragma once

#include "reflect/type_builder.hpp"

namespace plumb {

/// Rotates the entity at a constant rate.
struct Spin {
    float rate = 1.0f;  ///< rad/s, clockwise on screen

    static void describe(TypeBuilder<Spin>& type) {
        type.name("Spin").doc("Rotates the entity at a constant rate.");
        type.field<&Spin::rate>("rate")
            .unit(Unit::RadiansPerSecond)
            .range(-100.0f, 100.0f)
            .doc("Rate of rotation, degrees/s, clockwise on screen.");
    }
};

}  // namespace plumb
