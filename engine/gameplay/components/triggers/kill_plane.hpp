#pragma once

#include "reflect/type_builder.hpp"

namespace plumb {

/// Kills whatever has Health, and removes loose bodies, below the Transform of this entity.
struct KillPlane {
    static void describe(TypeBuilder<KillPlane>& type) {
        type.name("KillPlane")
            .doc("Kills whatever has Health, and removes loose bodies, below the Transform of this entity.");
    }
};

}  // namespace plumb
