#pragma once

#include "reflect/type_builder.hpp"

namespace plumb {

/// Keeps the entity and its children alive when the game changes to another scene.
struct Persistent {
    static void describe(TypeBuilder<Persistent>& type) {
        type.name("Persistent")
            .doc("Keeps the entity and its children alive when the game changes to another scene.");
    }
};

}  // namespace plumb
