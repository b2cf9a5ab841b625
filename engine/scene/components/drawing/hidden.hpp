#pragma once

#include "reflect/type_builder.hpp"

namespace plumb {

/// Hides the entity and its children: they are not drawn.
struct Hidden {
    static void describe(TypeBuilder<Hidden>& type) {
        type.name("Hidden").doc("Hides the entity and its children: they are not drawn.");
    }
};

}  // namespace plumb
