#pragma once

#include "reflect/type_builder.hpp"

namespace plumb {

/// Settings of a scene that is opened as an overlay over other scenes; on any entity of that scene. An
/// overlay without this component pauses the scenes below and takes their input, as menus do.
struct Overlay {
    bool pauses = true;      ///< pauses the scenes below
    bool takesInput = true;  ///< the scenes below receive no input

    static void describe(TypeBuilder<Overlay>& type) {
        type.name("Overlay").doc(
            "Settings that apply when this scene is opened as an overlay over other scenes.");
        type.field<&Overlay::pauses>("pauses").doc("Pauses the scenes below.");
        type.field<&Overlay::takesInput>("takesInput").doc("The scenes below receive no input.");
    }
};

}  // namespace plumb
