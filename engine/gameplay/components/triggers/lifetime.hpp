#pragma once

#include "reflect/type_builder.hpp"

namespace plumb {

/// Destroys the entity after a while.
struct Lifetime {
    float seconds = 1.0f;  ///< s, left to live

    static void describe(TypeBuilder<Lifetime>& type) {
        type.name("Lifetime").doc("Destroys the entity after a while.");
        type.field<&Lifetime::seconds>("seconds")
            .unit(Unit::Seconds)
            .range(0.0f, 3600.0f)
            .doc("Left to live.");
    }
};

}  // namespace plumb
