#pragma once

#include "reflect/type_builder.hpp"

namespace plumb {

/// What can be hurt. Without Respawn, none left destroys the entity.
struct Health {
    int points = 1;
    int most = 1;        ///< hearts do not fill it further
    int safeTicks = 60;  ///< ticks, blinks and cannot be hurt again
    int safe = 0;        ///< ticks, left of safeTicks

    static void describe(TypeBuilder<Health>& type) {
        type.name("Health").doc("What can be hurt. Without Respawn, none left destroys the entity.");
        type.field<&Health::points>("points").range(0.0f, 1000.0f);
        type.field<&Health::most>("most").range(1.0f, 1000.0f).doc("Hearts do not fill it further.");
        type.field<&Health::safeTicks>("safeTicks")
            .unit(Unit::Ticks)
            .range(0.0f, 600.0f)
            .doc("Blinks and cannot be hurt again.");
        type.field<&Health::safe>("safe").unit(Unit::Ticks).transient();
    }
};

}  // namespace plumb
