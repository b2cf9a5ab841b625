#pragma once

#include "reflect/type_builder.hpp"

namespace plumb {

/// Lets the player accelerate a RigidBody with the axes Horizontal and Vertical, and make it jump from the
/// ground. The body still obeys friction and collisions.
struct PushControl {
    float acceleration = 900.0f;  ///< px/s^2, on the ground and in the air
    float maxSpeed = 260.0f;      ///< px/s per axis, above which it does not accelerate further
    float jumpSpeed = 420.0f;     ///< px/s, initial upward speed of a jump; 0: cannot jump
    bool flies = false;           ///< the axis Vertical accelerates the body too

    static void describe(TypeBuilder<PushControl>& type) {
        type.name("PushControl")
            .doc("Lets the player accelerate a RigidBody with the input axes, and make it jump.");
        type.field<&PushControl::acceleration>("acceleration")
            .unit(Unit::PixelsPerSecondSquared)
            .range(0.0f, 1e5f)
            .doc("Acceleration of the body, px/s2.");
        type.field<&PushControl::maxSpeed>("maxSpeed")
            .unit(Unit::PixelsPerSecond)
            .range(0.0f, 1e5f)
            .doc("Speed per axis above which the player cannot accelerate the body further, px/s.");
        type.field<&PushControl::jumpSpeed>("jumpSpeed")
            .unit(Unit::PixelsPerSecond)
            .range(0.0f, 1e5f)
            .doc("Initial upward speed of a jump, px/s; 0: cannot jump.");
        type.field<&PushControl::flies>("flies").doc("The axis Vertical accelerates the body too.");
    }
};

}  // namespace plumb
