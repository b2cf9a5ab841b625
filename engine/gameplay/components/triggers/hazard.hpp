#pragma once

#include "math/vec2.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// A trigger that hurts what has Health and touches it: spikes, fire, enemies.
struct Hazard {
    int damage = 1;                      ///< points of health it takes
    Vec2 knockback = {120.0f, -160.0f};  ///< px/s, thrown away from it, if that does not kill

    static void describe(TypeBuilder<Hazard>& type) {
        type.name("Hazard").doc(
            "A trigger that hurts what has Health and touches it: spikes, fire, enemies.");
        type.field<&Hazard::damage>("damage").range(0.0f, 1000.0f).doc("Points of health it takes.");
        type.field<&Hazard::knockback>("knockback")
            .unit(Unit::PixelsPerSecond)
            .doc("Thrown away from it, if that does not kill.");
    }
};

}  // namespace plumb
