#pragma once

#include "math/color.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// Gives the entity's Sprite another color while it is in a trigger.
struct TouchColor {
    Color color{255, 216, 102, 255};
    Color before;              ///< its own color, while it is in one
    std::int32_t touched = 0;  ///< how many triggers it is in

    static void describe(TypeBuilder<TouchColor>& type) {
        type.name("TouchColor").doc("Gives the Sprite another color while the entity is in a trigger.");
        type.field<&TouchColor::color>("color");
        type.field<&TouchColor::before>("before").transient();
        type.field<&TouchColor::touched>("touched").transient();
    }
};

}  // namespace plumb
