#pragma once

#include "reflect/type_builder.hpp"

namespace plumb {

/// Kills entities with Health, and destroys other entities
/// with a RigidBody, below the Transform of this entity.
struct KillPlane {
    static void describe(TypeBuilder<KillPlane>& type) {
        type.name("KillPlane")
            .doc(
                "Kills entities with Health, and destroys other bodies, below the Transform of this entity.");
    }
};

}  // namespace plumb
