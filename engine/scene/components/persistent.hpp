#pragma once

#include "reflect/type_builder.hpp"

namespace plumb {

/// Survives the change to another scene.
struct Persistent {
    static void describe(TypeBuilder<Persistent>& type) {
        type.name("Persistent").doc("Survives the change to another scene.");
    }
};

}  // namespace plumb
