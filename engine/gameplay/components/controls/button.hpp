#pragma once

#include "reflect/type_builder.hpp"

namespace plumb {

/// A trigger that opens doors while something stands on it.
struct Button {
    bool stays = false;  ///< stays pressed for good
    bool pressed = false;
    int held = 0;  ///< ticks, left until it comes up

    static void describe(TypeBuilder<Button>& type) {
        type.name("Button").doc("A trigger that opens doors while something stands on it.");
        type.field<&Button::stays>("stays").doc("Stays pressed for good.");
        type.field<&Button::pressed>("pressed").transient();
        type.field<&Button::held>("held").unit(Unit::Ticks).transient();
    }
};

}  // namespace plumb
