#pragma once

#include "reflect/type_builder.hpp"

namespace plumb {

/// Is not drawn, nor are its children.
struct Hidden {
    static void describe(TypeBuilder<Hidden>& type) {
        type.name("Hidden").doc("Is not drawn, nor are its children.");
    }
};

}  // namespace plumb
