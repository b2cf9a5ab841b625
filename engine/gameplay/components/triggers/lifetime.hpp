#pragma once

#include "reflect/type_builder.hpp"

namespace plumb {

/// Destroys the entity after a given time.
struct Lifetime {
    float seconds = 1.0f;  ///< s until the entity is destroyed

    static void describe(TypeBuilder<Lifetime>& type) {
        type.name("Lifetime").doc("Destroys the entity after a given time.");
        type.field<&Lifetime::seconds>("seconds")
            .unit(Unit::Seconds)
            .range(0.0f, 3600.0f)
            .doc("Time until the entity is destroyed, s.");
    }
};

}  // namespace plumb
