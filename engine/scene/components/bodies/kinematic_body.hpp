#pragma once

#include "math/vec2.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// A body that moves at its own velocity, is not affected by
/// forces, and pushes dynamic bodies: platforms, doors, lifts.
struct KinematicBody {
    Vec2 velocity;                 ///< px/s
    float angularVelocity = 0.0f;  ///< rad/s, clockwise on screen

    static void describe(TypeBuilder<KinematicBody>& type) {
        type.name("KinematicBody")
            .doc(
                "Moves at its velocity, unaffected by forces, and pushes dynamic bodies: platforms, doors, "
                "lifts.");
        type.field<&KinematicBody::velocity>("velocity").unit(Unit::PixelsPerSecond);
        type.field<&KinematicBody::angularVelocity>("angularVelocity")
            .unit(Unit::RadiansPerSecond)
            .doc("Angular velocity, degrees/s, clockwise on screen.");
    }
};

}  // namespace plumb
