#pragma once

#include "math/color.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// Changes the tint of the entity's Sprite while the entity is in a trigger.
struct TouchColor {
    Color color{255, 216, 102, 255};  ///< tint while the entity is in a trigger
    Color before;                     ///< original tint, to restore
    std::int32_t touched = 0;         ///< number of triggers that the entity is in

    static void describe(TypeBuilder<TouchColor>& type) {
        type.name("TouchColor").doc("Changes the tint of the Sprite while the entity is in a trigger.");
        type.field<&TouchColor::color>("color").doc("Tint of the Sprite while the entity is in a trigger.");
        type.field<&TouchColor::before>("before").transient();
        type.field<&TouchColor::touched>("touched").transient();
    }
};

}  // namespace plumb
