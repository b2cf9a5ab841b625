#pragma once

#include <cstdint>

#include "reflect/type_builder.hpp"

namespace plumb {

/// The slot of saved games for a MenuItem or a SceneKey that saves or loads; without it slot 1.
struct SaveSlot {
    std::int32_t slot = 1;  ///< 1..32

    static void describe(TypeBuilder<SaveSlot>& type) {
        type.name("SaveSlot").doc("The slot of saved games for a MenuItem or a SceneKey; without it slot 1.");
        type.field<&SaveSlot::slot>("slot").range(1.0f, 32.0f).doc("Slot of saved games.");
    }
};

}  // namespace plumb
