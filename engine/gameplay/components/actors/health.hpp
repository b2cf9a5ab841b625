#pragma once

#include "reflect/type_builder.hpp"

namespace plumb {

/// Health points of the entity. At 0 it dies: it respawns if
/// it has a Respawn component, otherwise it is destroyed.
struct Health {
    int points = 1;      ///< current health points
    int most = 1;        ///< maximum health points
    int safeTicks = 60;  ///< ticks of invulnerability after damage, in which the entity blinks
    int safe = 0;        ///< remaining ticks of invulnerability

    static void describe(TypeBuilder<Health>& type) {
        type.name("Health").doc(
            "Health points. At 0 the entity dies: it respawns with a Respawn component, otherwise it is "
            "destroyed.");
        type.field<&Health::points>("points").range(0.0f, 1000.0f).doc("Current health points.");
        type.field<&Health::most>("most").range(1.0f, 1000.0f).doc("Maximum health points.");
        type.field<&Health::safeTicks>("safeTicks")
            .unit(Unit::Ticks)
            .range(0.0f, 600.0f)
            .doc("Time of invulnerability after damage, ticks; the entity blinks meanwhile.");
        type.field<&Health::safe>("safe").unit(Unit::Ticks).transient();
    }
};

}  // namespace plumb
