#pragma once

#include "reflect/type_builder.hpp"

namespace plumb {

/// A trigger that opens doors while a body is on it.
struct Button {
    bool stays = false;    ///< stays pressed permanently after the first press
    bool pressed = false;  ///< pressed now
    int held = 0;          ///< ticks until it is released

    static void describe(TypeBuilder<Button>& type) {
        type.name("Button").doc("A trigger that opens doors while a body is on it.");
        type.field<&Button::stays>("stays").doc(
            "The button stays pressed permanently after the first press.");
        type.field<&Button::pressed>("pressed").transient();
        type.field<&Button::held>("held").unit(Unit::Ticks).transient();
    }
};

}  // namespace plumb
