#pragma once

#include "math/vec2.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// A trigger that damages entities with Health on touch: spikes, fire, enemies.
struct Hazard {
    int damage = 1;                      ///< health points that a touch removes
    Vec2 knockback = {120.0f, -160.0f};  ///< px/s, velocity of a hit entity that survives

    static void describe(TypeBuilder<Hazard>& type) {
        type.name("Hazard").doc(
            "A trigger that damages entities with Health on touch: spikes, fire, enemies.");
        type.field<&Hazard::damage>("damage").range(0.0f, 1000.0f).doc("Health points that a touch removes.");
        type.field<&Hazard::knockback>("knockback")
            .unit(Unit::PixelsPerSecond)
            .doc("Velocity given to a hit entity that survives, px/s; x > 0: away from the hazard.");
    }
};

}  // namespace plumb
