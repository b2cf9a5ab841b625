#pragma once

#include "reflect/type_builder.hpp"

namespace plumb {

/// Says how its scene lies over others when it is opened as an overlay. Without one it pauses what is below
/// and takes the input, as menus do.
struct Overlay {
    bool pauses = true;      ///< what is below stands still
    bool takesInput = true;  ///< what is below hears nothing of the player

    static void describe(TypeBuilder<Overlay>& type) {
        type.name("Overlay").doc("How its scene lies over others when it is opened as an overlay.");
        type.field<&Overlay::pauses>("pauses").doc("What is below stands still.");
        type.field<&Overlay::takesInput>("takesInput").doc("What is below hears nothing of the player.");
    }
};

}  // namespace plumb
