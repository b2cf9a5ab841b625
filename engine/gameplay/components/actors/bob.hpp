#pragma once

#include "math/vec2.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// Lets the picture float up and down; colliders stay.
struct Bob {
    Vec2 amplitude = {0.0f, 2.0f};  ///< px, to both sides
    float period = 1.5f;            ///< s
    float phase = 0.0f;             ///< ratio, where in its period it begins
    float time = 0.0f;              ///< s since its period began; its own, so that a pause stops it
    Vec2 shown;                     ///< px, the offset that the picture has now

    static void describe(TypeBuilder<Bob>& type) {
        type.name("Bob").doc("Lets the picture float up and down; colliders stay.");
        type.field<&Bob::amplitude>("amplitude").unit(Unit::Pixels).doc("To both sides.");
        type.field<&Bob::period>("period").unit(Unit::Seconds).range(0.05f, 60.0f);
        type.field<&Bob::phase>("phase")
            .unit(Unit::Ratio)
            .range(0.0f, 1.0f)
            .doc("Where in its period it begins.");
        type.field<&Bob::time>("time").unit(Unit::Seconds).transient();
        type.field<&Bob::shown>("shown").unit(Unit::Pixels).transient();
    }
};

}  // namespace plumb
